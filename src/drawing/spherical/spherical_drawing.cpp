#include "spherical_drawing.hpp"

#include <fmt/format.h>

#include "drawing/four_bar/linkage_strip.hpp"
#include "drawing/palette.hpp"
#include "drawing/region_figure.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"

namespace linkwright {
namespace {

using namespace solution_sheet;

std::string spherical_subtitle(const Problem& problem, const SphericalAnswer& answer) {
  return sentence_case(task_label(problem.task)) + std::string(separator) +
         fmt::format("{0} four-bars sampled{3}{1} free of defects{3}{2} meet the requirements",
                     grouped_text(linkages_in(answer.counts)), grouped_text(answer.counts.defect_free),
                     grouped_text(answer.meeting_requirements), separator);
}

std::string angles_text(const LinkAngles& l) {
  return fmt::format("ground {}°, input {}°, coupler {}°, output {}°", rounded_text(degrees(l.ground), 2),
                     rounded_text(degrees(l.input), 2), rounded_text(degrees(l.coupler), 2),
                     rounded_text(degrees(l.output), 2));
}

}  // namespace

std::string draw_sheet(const Problem& problem, const SphericalMotionAnswer& answer) {
  SvgCanvas svg = solution_sheet::begin(problem, spherical_subtitle(problem, answer));
  constexpr PixelBox card{836, 84, 580, 664};
  draw_card(svg, card, "Solution region: every point is one four-bar");
  const PixelBox map{card.left + 76, card.top + 44, 444, 444};
  if (answer.family() && answer.region.rows() > 0) draw_region(svg, drawn_region(answer, problem.length_unit), map);
  draw_region_legend(svg, answer, {card.left + 18, map.bottom() + 70}, card.width - 24);
  draw_card(svg, strip_card, "");
  draw_wrapped(svg, {strip_card.left + 18, strip_card.top + 54},
               answer.linkages.empty() ? answer.reason.message : angles_text(answer.linkages.front().angles),
               strip_card.width - 36, 2);
  return svg.file();
}

std::string draw_linkage(const StoredSphericalFourBar& linkage) {
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Spherical four-bar" : linkage.title,
                                       angles_text(linkage.four_bar.angles()));
  return svg.file();
}

}  // namespace linkwright
