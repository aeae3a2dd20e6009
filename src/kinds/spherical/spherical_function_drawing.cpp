#include <fmt/format.h>

#include "drawing/error_plot.hpp"
#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/region_figure.hpp"
#include "drawing/sheet.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "spherical/spherical_function_linkage.hpp"
#include "spherical_figure.hpp"
#include "spherical_kind.hpp"

namespace linkwright {
namespace {

using namespace solution_sheet;

std::string generator_subtitle(const Problem& problem, const SphericalFunctionAnswer& answer) {
  return sentence_case(task_label(problem.task)) + std::string(separator) +
         fmt::format("{0} four-bars sampled{3}{1} free of defects{3}{2} meet the requirements",
                     grouped_text(linkages_in(answer.counts)), grouped_text(answer.counts.defect_free),
                     grouped_text(answer.meeting_requirements), separator);
}

std::string link_angles_text(const LinkAngles& l) {
  return fmt::format("Linkage 1: ground {}°, input {}°, coupler {}°, output {}°", rounded_text(degrees(l.ground), 2),
                     rounded_text(degrees(l.input), 2), rounded_text(degrees(l.coupler), 2),
                     rounded_text(degrees(l.output), 2));
}

void draw_generated(SvgCanvas& svg, const SphericalFunctionAnswer& answer, const PixelBox& box) {
  const SphericalSolution& first = answer.linkages.front();
  if (!first.function) return;
  const SphericalFunctionTask there =
      answer.task.free ? task_at(answer.task, answer.task.free->at(first.output.coordinate)) : answer.task;
  first.function->samples.empty()
      ? draw_output_plot(svg, box, generated_function(first.four_bar, there.pairs.front()), there)
      : draw_error_plot(svg, box, *first.function, there);
}

/// In both views, at the first pair.
void draw_linkage(SvgCanvas& svg, const SphericalFunctionAnswer& answer, Point corner) {
  const SphericalSolution& best = answer.linkages.front();
  StoredSphericalFourBar linkage;
  linkage.four_bar = best.four_bar;
  linkage.orientations = answer.family()->orientations({best.input.coordinate, best.output.coordinate}, best.four_bar);
  const SphericalScene scene = scene_of(linkage);
  draw_views(svg, scene, corner + Point{222, 188}, corner + Point{574, 188}, 134);
  const Point keys = corner + Point{206, 392};
  draw_line_key(svg, keys, marker_path_stroke(), "path of the coupler's middle");
  if (!scene.dead_points.empty()) draw_dead_point_key(svg, keys + Point{270, 0});
}

}  // namespace

std::string draw_sheet(const Problem& problem, const SphericalFunctionAnswer& answer) {
  SvgCanvas svg = solution_sheet::begin(problem, generator_subtitle(problem, answer));
  constexpr PixelBox map_card{836, 84, 580, 664}, plot_card{24, 84, 796, 664};
  constexpr double ribbon = 72, side = 444;
  draw_card(svg, plot_card, answer.linkages.empty() ? "" : "Best spherical four-bar");
  if (!answer.linkages.empty()) {
    draw_linkage(svg, answer, plot_card.corner());
    draw_generated(svg, answer, {plot_card.left + 76, plot_card.top + 426, plot_card.width - 116, 172});
  }
  draw_card(svg, map_card, "Solution region: every value is one four-bar");
  const PixelBox map{map_card.left + 76, map_card.top + 44, side, is_ribbon(answer.family()) ? ribbon : side};
  if (answer.family() && answer.region.rows() > 0) draw_region(svg, region_of(answer, problem.length_unit), map);
  const Point legend{map_card.left + 18, map_card.top + 44 + side + 70};
  draw_region_legend(svg, answer, spherical_linkages, legend, map_card.width - 24);
  draw_card(svg, strip_card, "");
  draw_wrapped(svg, {strip_card.left + 18, strip_card.top + 54},
               answer.linkages.empty() ? answer.reason.message : link_angles_text(answer.linkages.front().angles),
               strip_card.width - 36, 2);
  return svg.file();
}

}  // namespace linkwright
