#include <fmt/format.h>

#include "drawing/four_bar/error_plot.hpp"
#include "drawing/four_bar/linkage_strip.hpp"
#include "drawing/six_bar/six_bar_drawing.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "palette.hpp"
#include "region_figure.hpp"
#include "sheet.hpp"
#include "svg_canvas.hpp"
#include "task_scene.hpp"

namespace linkwright {
namespace {

using namespace solution_sheet;
constexpr PixelBox region_card{836, 84, 580, 664};

std::string_view region_heading(const Solution& solution) {
  if (is_board(solution))
    return is_ribbon(solution) ? "Every cell is one four-bar" : "Every cell is a pair of side links";
  return is_ribbon(solution) ? "Solution ribbon: every place is one four-bar"
                             : "Solution region: every point is one four-bar";
}

/// A function that one linkage generates, which a plot shows below the cells.
bool has_plot(const TaskScene& scene) { return scene.linkage != nullptr && scene.linkage->function && scene.function; }

void draw_plot(SvgCanvas& svg, const TaskScene& scene, const PixelBox& box) {
  if (scene.linkage == nullptr || !scene.linkage->function || !scene.function) return;
  const FunctionError& error = *scene.linkage->function;
  error.samples.empty() ? draw_output_plot(svg, box, scene.linkage->four_bar, *scene.function)
                        : draw_error_plot(svg, box, error, *scene.function);
}

/// The cells, and room for a plot below them where there is one.
void draw_map_and_plot(SvgCanvas& svg, const Problem& problem, const Solution& solution, const TaskScene& scene) {
  constexpr double side = 444, left_axis = 76, below_heading = 44, axis = 70;
  const double left = region_card.left + left_axis, top = region_card.top + below_heading;
  constexpr double ribbon = 72, low_map = 214;
  const double cells = is_ribbon(solution) ? ribbon : has_plot(scene) ? low_map : side;
  draw_region(svg, problem, solution, {left, top, side, cells});
  constexpr double plot_heading = 26, plot_axis = 46;
  const double plot_top = top + cells + axis + plot_heading, plot_bottom = top + side + axis - plot_axis - 6;
  draw_plot(svg, scene, {left, plot_top, side, plot_bottom - plot_top});
  draw_region_legend(svg, solution, {region_card.left + 18, top + side + axis}, region_card.width - 24);
}

void draw_region_card(SvgCanvas& svg, const Problem& problem, const Solution& solution, const TaskScene& scene) {
  draw_card(svg, region_card, region_heading(solution));
  if (solution.region.rows() > 0) return draw_map_and_plot(svg, problem, solution, scene);
  const auto* motion = std::get_if<MotionTask>(&problem.task);
  const bool asks_for_curve = motion != nullptr && position_count(motion->poses) == 4;
  svg.text({region_card.left + region_card.width / 2, region_card.top + region_card.height / 2},
           asks_for_curve ? "There is no region: the dyads of this task do not form a curve."
                          : "There is no region: no two side links do this task.",
           {.size = 14, .color = palette::ink2, .anchor = "middle"});
}

/// What it is, where that is not four positions, whose curve tells.
std::string kind_words(const Problem& problem, const Solution& solution) {
  const auto* motion = std::get_if<MotionTask>(&problem.task);
  const bool is_plain = motion != nullptr && position_count(motion->poses) == 4;
  const bool of_couplers = std::holds_alternative<FunctionTask>(problem.task);
  std::string text = is_plain ? "" : sentence_case(task_label(problem.task));
  if (motion != nullptr && !solution.given.curve && !solution.given.points.empty())
    text += fmt::format(": {} Burmester point{}", solution.given.points.size(),
                        solution.given.points.size() == 1 ? "" : "s");
  if (!solution.given.curve) return text;
  const std::string curve =
      fmt::format("{}: {}", of_couplers ? "curve of couplers" : "Burmester curve", label(solution.given.curve->kind()));
  return text.empty() ? curve : text + std::string(separator) + sentence_case(curve);
}

std::string subtitle(const Problem& problem, const Solution& solution) {
  std::string text = kind_words(problem, solution);
  if (solution.counts.pairs == 0) return text;
  return text + fmt::format("{0}{1} {4} sampled{0}{2} free of defects{0}{3} {5} the requirements", separator,
                            grouped_text(four_bars_in(solution.counts)), grouped_text(solution.counts.defect_free),
                            grouped_text(solution.meeting_requirements),
                            four_bars_in(solution.counts) == 1 ? "four-bar" : "four-bars",
                            solution.meeting_requirements == 1 ? "meets" : "meet");
}

void draw_strip(SvgCanvas& svg, const Problem& problem, const Solution& solution) {
  solution.linkages.empty() ? draw_reason_strip(svg, strip_card, solution, problem.length_unit)
                            : draw_linkage_strip(svg, strip_card, solution, problem.length_unit);
}

}  // namespace

std::string draw_solution(const Problem& problem, const Solution& solution) {
  if (const auto* six_bar = std::get_if<SixBarTask>(&problem.task))
    return draw_six_bar_solution(problem, *six_bar, solution);
  SvgCanvas svg = solution_sheet::begin(problem, subtitle(problem, solution));
  const TaskScene scene = task_scene(problem, solution);
  draw_task_scene(svg, scene, problem, solution, task_card);
  draw_region_card(svg, problem, solution, scene);
  draw_strip(svg, problem, solution);
  return svg.file();
}

}  // namespace linkwright
