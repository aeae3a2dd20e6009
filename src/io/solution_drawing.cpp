#include <array>
#include <cmath>
#include <fmt/format.h>

#include "curve_path.hpp"
#include "linkage_figure.hpp"
#include "linkage_positions.hpp"
#include "linkage_strip.hpp"
#include "linkwright/io/label.hpp"
#include "linkwright/io/number_text.hpp"
#include "linkwright/io/svg_drawing.hpp"
#include "palette.hpp"
#include "region_figure.hpp"
#include "svg_canvas.hpp"

namespace linkwright {
namespace {

constexpr double width = 1440, height = 900, border = 24;
constexpr PixelBox task_card{border, 84, 796, 664};
constexpr PixelBox region_card{836, 84, 580, 664};
constexpr PixelBox strip_card{border, 764, width - 2 * border, 112};

const FourBarSolution* best_of(const Solution& solution) {
  return solution.linkages.empty() ? nullptr : &solution.linkages.front();
}

const std::vector<PrescribedPose>& poses_of(const Problem& problem) {
  static const std::vector<PrescribedPose> none;
  const auto* motion = std::get_if<MotionTask>(&problem.task);
  return motion ? motion->poses : none;
}

Point first_origin(const Problem& problem) { return poses_of(problem).front().pose.origin; }

/// What the window must hold: the poses with their arms' room, and the best linkage in all its positions. `size`: of
/// what there is to see about a single pose.
std::vector<Point> points_of_interest(const Problem& problem, const FourBarSolution* best, double size) {
  std::vector<Point> points;
  const auto& poses = poses_of(problem);
  for (const PrescribedPose& pose : poses) points.push_back(pose.pose.origin);
  if (best == nullptr && poses.size() == 1) points = {points[0] - size, points[0] + size};
  if (best == nullptr) return points;
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    const FourBar bars = in_pose(best->four_bar, poses, pose);
    points.insert(points.end(), {bars.input_center, bars.input_circle, bars.output_center, bars.output_circle});
  }
  for (const Point p : path_of_task(best->four_bar, poses, first_origin(problem))) points.push_back(p);
  return points;
}

/// Without a linkage the poses alone leave no room to see the curves.
double window_margin(const FourBarSolution* best) { return best ? 76 : 170; }

void draw_curves(SvgCanvas& svg, const Solution& solution, const PlaneWindow& window) {
  if (!solution.given.curve) return;
  const CurvePaths paths = visible_curves(*solution.given.curve, solution.given.frame(), window);
  for (const auto& path : paths.centers) svg.polyline(path, stroke(palette::curve, 1.5));
  for (const auto& path : paths.circles) svg.polyline(path, stroke(palette::curve, 1.5, "5 4"));
}

void draw_best_linkage(SvgCanvas& svg, const Problem& problem, const FourBarSolution& best, const PlaneWindow& window) {
  const auto& poses = poses_of(problem);
  const Point traced = first_origin(problem);
  draw_traced_path(svg, window, path_of_cycle(best.four_bar, traced), false);
  for (std::size_t pose = poses.size(); --pose > 0;) draw_ghost(svg, window, in_pose(best.four_bar, poses, pose));
  draw_traced_path(svg, window, path_of_task(best.four_bar, poses, traced), true);
  draw_body(svg, window, best.four_bar, traced);
}

/// The keys of the lines, right of the heading.
void draw_keys(SvgCanvas& svg, const PixelBox& card, bool has_linkage) {
  const std::string dotted = stroke(palette::accent, 2, "0.1 4.5") + " stroke-linecap=\"round\"";
  const double y = card.top + 24;
  double x = card.left + (has_linkage ? 190 : 440);
  x = draw_line_key(svg, {x, y}, stroke(palette::curve, 1.5), "centre-point curve");
  x = draw_line_key(svg, {x, y}, stroke(palette::curve, 1.5, "5 4"), "circle-point curve");
  if (has_linkage) draw_line_key(svg, {x, y}, dotted, "path of the frame's origin");
}

void draw_task(SvgCanvas& svg, const Problem& problem, const Solution& solution) {
  draw_card(svg, task_card, solution.linkages.empty() ? "The four positions" : "Best linkage");
  const PixelBox box{task_card.left + 1, task_card.top + 44, task_card.width - 2, task_card.height - 45};
  const FourBarSolution* best = best_of(solution);
  const PlaneWindow window(box, points_of_interest(problem, best, solution.given.frame().scale), window_margin(best));
  svg.begin_clip(box.corner(), box.width, box.height);
  draw_grid(svg, window);
  const Requirements& requirements = solution.requirements;
  if (requirements.ground_pivots_within) draw_box(svg, window, *requirements.ground_pivots_within, "ground pivots");
  if (requirements.moving_pivots_within) draw_box(svg, window, *requirements.moving_pivots_within, "moving pivots");
  draw_curves(svg, solution, window);
  if (best != nullptr) draw_best_linkage(svg, problem, *best, window);
  if (best != nullptr) draw_bars(svg, window, best->four_bar);
  for (std::size_t pose = poses_of(problem).size(); pose-- > 0;) {
    draw_direction(svg, window, poses_of(problem)[pose]);
    draw_pose(svg, window, poses_of(problem)[pose].pose, pose + 1, pose == 0);
  }
  if (best != nullptr) draw_pins(svg, window, best->four_bar);
  draw_scale_bar(svg, window, {box.left + 22, box.bottom() - 20}, problem.length_unit);
  svg.end_group();
  draw_keys(svg, task_card, best != nullptr);
}

void draw_region_card(SvgCanvas& svg, const Solution& solution) {
  draw_card(svg, region_card, "Solution region: every point is one four-bar");
  constexpr double side = 444, left_axis = 76;
  const PixelBox map{region_card.left + left_axis, region_card.top + 44, side, side};
  if (solution.region.rows() == 0) {
    svg.text({region_card.left + region_card.width / 2, region_card.top + region_card.height / 2},
             "There is no region: the dyads of this task do not form a curve.",
             {.size = 14, .color = palette::ink2, .anchor = "middle"});
    return;
  }
  draw_region(svg, solution, map);
  draw_region_legend(svg, solution, {region_card.left + 18, map.bottom() + 70}, region_card.width - 24);
}

std::string subtitle(const Solution& solution) {
  std::string text;
  if (solution.given.curve) text = fmt::format("Burmester curve: {}", label(solution.given.curve->kind()));
  if (solution.counts.pairs == 0) return text;
  return text + fmt::format("   ·   {} four-bars sampled   ·   {} free of defects   ·   {} meet the requirements",
                            grouped_text(four_bars_in(solution.counts)), grouped_text(solution.counts.defect_free),
                            grouped_text(solution.meeting_requirements));
}

void draw_header(SvgCanvas& svg, const Problem& problem, const Solution& solution) {
  const std::string title = problem.title.empty() ? "Four positions" : problem.title;
  svg.text({border, 42}, fitted(title, 24, 0.92 * (width - 2 * border)), {.size = 24, .weight = 650});
  svg.text({border, 66}, subtitle(solution), {.size = 14, .color = palette::ink2});
}

void draw_strip(SvgCanvas& svg, const Problem& problem, const Solution& solution) {
  if (const FourBarSolution* best = best_of(solution)) {
    draw_linkage_strip(svg, strip_card, *best, problem.length_unit);
  } else {
    draw_card(svg, strip_card, "No linkage to show");
    draw_wrapped(svg, {strip_card.left + 18, strip_card.top + 54}, solution.reason.message, strip_card.width - 36, 2);
  }
}

}  // namespace

std::string draw_solution(const Problem& problem, const Solution& solution) {
  SvgCanvas svg(width, height, problem.title.empty() ? "Linkwright solution" : problem.title);
  svg.rectangle({0, 0}, width, height, fill(palette::page));
  draw_header(svg, problem, solution);
  draw_task(svg, problem, solution);
  draw_region_card(svg, solution);
  draw_strip(svg, problem, solution);
  return svg.file();
}

}  // namespace linkwright
