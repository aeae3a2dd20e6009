#include <fmt/format.h>

#include "drawing/error_plot.hpp"
#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/palette.hpp"
#include "drawing/region_figure.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "drawing/task_scene.hpp"
#include "four_bar_kind.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "planar/function_linkage.hpp"

namespace linkwright {
namespace {

using namespace solution_sheet;
constexpr PixelBox region_card{836, 84, 580, 664};

std::string_view region_heading(const LinkageFamily* family) {
  if (family != nullptr && family->axis(Side::input).layers > 0)
    return "Solution region: every point is the best of its place";
  if (is_board(family))
    return is_ribbon(family) || family->axis(Side::output).quantity == AxisQuantity::realisation
               ? "Solution region: every cell is one four-bar"
               : "Solution region: every cell is a pair of dyads";
  return is_ribbon(family) ? "Solution region: every value is one four-bar"
                           : "Solution region: every point is one four-bar";
}

/// A function that one linkage generates, which a plot shows below the cells.
bool has_plot(const TaskScene& scene) { return scene.linkage != nullptr && scene.linkage->function && scene.function; }

void draw_plot(SvgCanvas& svg, const TaskScene& scene, const PixelBox& box) {
  if (scene.linkage == nullptr || !scene.linkage->function || !scene.function) return;
  const FunctionError& error = *scene.linkage->function;
  error.samples.empty()
      ? draw_output_plot(svg, box, generated_function(scene.linkage->four_bar, scene.function->pairs.front()),
                         *scene.function)
      : draw_error_plot(svg, box, error, *scene.function);
}

/// The cells, and room for a plot below them where there is one.
void draw_map_and_plot(SvgCanvas& svg, const DrawnRegion& region, const TaskScene& scene) {
  constexpr double side = 444, left_axis = 76, below_heading = 44, axis = 70;
  const double left = region_card.left + left_axis, top = region_card.top + below_heading;
  constexpr double ribbon = 72, low_map = 214;
  const double cells = is_ribbon(&region.family) ? ribbon : has_plot(scene) ? low_map : side;
  draw_region(svg, region, {left, top, side, cells});
  constexpr double plot_heading = 26, plot_axis = 46;
  const double plot_top = top + cells + axis + plot_heading, plot_bottom = top + side + axis - plot_axis - 6;
  draw_plot(svg, scene, {left, plot_top, side, plot_bottom - plot_top});
  draw_region_legend(svg, region.found, planar_linkages, {region_card.left + 18, top + side + axis},
                     region_card.width - 24);
}

/// Why there is no map to see.
std::string_view no_region_words(const MotionAnswer& answer) {
  if (!answer.task.pivots_on.empty() && answer.given.curve)
    return "There is no solution region: no dyad has its pivot on the line.";
  return position_count(answer.task.poses) == 4
             ? "There is no solution region: the dyads of this task do not form a curve."
             : "There is no solution region: no two dyads do this task.";
}
std::string_view no_region_words(const PathAnswer& answer) {
  return position_count(answer.task.points) == 4
             ? "There is no solution region: the cranks of this task do not form a curve."
             : "There is no solution region: no two cranks do this task.";
}
std::string_view no_region_words(const FunctionAnswer& /*answer*/) {
  return "There is no solution region: no two dyads do this task.";
}

template <class KindAnswer>
DrawnRegion region_of(const KindAnswer& answer, std::string_view length_unit) {
  const FourBarFamily& family = *answer.family();
  const RegionMap& map = answer.region;
  return drawn_region(answer,
                      {axis_label(answer, Side::input, length_unit), palette::input,
                       family.dyads(Side::input, map.input_coordinates())},
                      {axis_label(answer, Side::output, length_unit), palette::output,
                       family.dyads(Side::output, map.output_coordinates())});
}

template <class KindAnswer>
void draw_region_card(SvgCanvas& svg, const Problem& problem, const KindAnswer& answer, const TaskScene& scene) {
  draw_card(svg, region_card, region_heading(answer.family()));
  if (answer.region.rows() > 0) return draw_map_and_plot(svg, region_of(answer, problem.length_unit), scene);
  svg.text({region_card.left + region_card.width / 2, region_card.top + region_card.height / 2},
           no_region_words(answer), {.size = 14, .color = palette::ink2, .anchor = "middle"});
}

std::string with_curve(std::string text, const FourBarAnswer& answer, std::string_view name) {
  if (!answer.given.curve) return text;
  const std::string curve = fmt::format("{}: {}", name, label(answer.given.curve->kind()));
  return text.empty() ? curve : text + std::string(separator) + sentence_case(curve);
}

/// What the task is, where that is not four positions, whose curve tells.
std::string kind_words(const MotionAnswer& answer) {
  const std::size_t points = answer.given.points.size();
  const bool is_plain = position_count(answer.task.poses) == 4 && answer.task.pivots_on.empty();
  std::string text = is_plain ? "" : sentence_case(task_label(answer.task));
  if (!answer.given.curve && points > 0) text += fmt::format(": {} Burmester point{}", points, points == 1 ? "" : "s");
  return with_curve(std::move(text), answer, "Burmester curve");
}
std::string kind_words(const FunctionAnswer& answer) {
  return with_curve(sentence_case(task_label(answer.task)), answer, "curve of couplers");
}

std::string kind_words(const PathAnswer& answer) {
  return with_curve(sentence_case(task_label(answer.task)), answer, "curve of cranks");
}

std::string subtitle(std::string text, const Findings& found) {
  if (found.counts.pairs == 0) return text;
  return text + fmt::format("{0}{1} {4} sampled{0}{2} free of defects{0}{3} {5} the requirements", separator,
                            grouped_text(linkages_in(found.counts)), grouped_text(found.counts.defect_free),
                            grouped_text(found.meeting_requirements),
                            linkages_in(found.counts) == 1 ? "four-bar" : "four-bars",
                            found.meeting_requirements == 1 ? "meets" : "meet");
}

template <class KindAnswer>
std::string draw_four_bars(const Problem& problem, const KindAnswer& answer) {
  SvgCanvas svg = solution_sheet::begin(problem, subtitle(kind_words(answer), answer));
  const TaskScene scene = task_scene(answer);
  draw_task_scene(svg, scene, problem, answer, task_card);
  draw_region_card(svg, problem, answer, scene);
  answer.linkages.empty() ? draw_reason_strip(svg, strip_card, answer, problem.length_unit)
                          : draw_linkage_strip(svg, strip_card, answer, problem.length_unit);
  return svg.file();
}

}  // namespace

std::string draw_sheet(const Problem& problem, const MotionAnswer& answer) { return draw_four_bars(problem, answer); }
std::string draw_sheet(const Problem& problem, const FunctionAnswer& answer) { return draw_four_bars(problem, answer); }
std::string draw_sheet(const Problem& problem, const PathAnswer& answer) { return draw_four_bars(problem, answer); }

}  // namespace linkwright
