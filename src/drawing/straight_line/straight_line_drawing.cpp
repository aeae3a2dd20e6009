#include "drawing/straight_line/straight_line_drawing.hpp"

#include <fmt/format.h>

#include "drawing/region_figure.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/files/task_label.hpp"

namespace linkwright {

std::string draw_sheet(const Problem& problem, const StraightLineAnswer& answer) {
  using namespace solution_sheet;
  SvgCanvas svg = begin(problem, sentence_case(task_label(answer.task)));
  constexpr PixelBox map{912, 128, 444, 444};
  if (answer.region.rows() > 0) draw_region(svg, drawn_region(answer, problem.length_unit), map);
  draw_region_legend(svg, answer, straight_line_linkages, {854, map.bottom() + 70}, 556);
  return svg.file();
}

}  // namespace linkwright
