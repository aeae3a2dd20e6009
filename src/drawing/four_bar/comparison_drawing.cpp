#include <algorithm>
#include <fmt/format.h>

#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "drawing/sheet.hpp"
#include "linkage_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr PixelBox comparison_card{linkage_sheet::border, 64, linkage_sheet::width - 2 * linkage_sheet::border, 592};
constexpr PixelBox comparison_scene{comparison_card.left + 1, comparison_card.top + 1, comparison_card.width - 2,
                                    comparison_card.height - 2};
constexpr PixelBox comparison_strip{linkage_sheet::border, 672, linkage_sheet::width - 2 * linkage_sheet::border, 108};

// The points, and from each the way to where the path is.
void draw_distances(SvgCanvas& svg, const PlaneWindow& window, const PathComparison& comparison) {
  for (std::size_t j = 0; j < comparison.path.at.size(); ++j) {
    const Point wanted = window.to_px(comparison.target.points[j]);
    svg.line(wanted, window.to_px(comparison.path.at[j].place), stroke(palette::bad, 2));
    const bool is_farthest = comparison.path.at[j].point == comparison.path.error.max_at;
    svg.circle(wanted, is_farthest ? 5 : 3, fill(is_farthest ? palette::bad : palette::ink));
  }
}

void draw_comparison_scene(SvgCanvas& svg, const PathComparison& comparison, std::string_view unit) {
  constexpr double margin = 48;
  const FourBar& bars = comparison.path.realisations.front();
  const std::vector<Point> path = path_of_cycle(bars, comparison.first_place);
  std::vector<Point> seen = {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving,
                             comparison.first_place};
  seen.insert(seen.end(), comparison.target.points.begin(), comparison.target.points.end());
  seen.insert(seen.end(), path.begin(), path.end());
  const PlaneWindow window(comparison_scene, seen, margin);
  svg.begin_clip(comparison_scene.corner(), comparison_scene.width, comparison_scene.height);
  draw_grid(svg, window);
  draw_body(svg, window, bars, comparison.first_place);
  draw_traced_path(svg, window, path, true);
  draw_bars(svg, window, bars);
  draw_pins(svg, window, bars);
  draw_distances(svg, window, comparison);
  draw_scale_bar(svg, window, {comparison_scene.left + 24, comparison_scene.bottom() - 18}, unit);
  svg.end_group();
}

void draw_pose_scene(SvgCanvas& svg, const PoseComparison& comparison, std::string_view unit) {
  constexpr double margin = 60;
  const FourBar& bars = comparison.bars;
  const Point origin = comparison.miss.at.front().body.origin;
  const std::vector<Point> path = path_of_cycle(bars, origin);
  std::vector<Point> seen = {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving};
  for (const Pose& pose : comparison.target.poses) seen.push_back(pose.origin);
  for (const NearMiss::Nearest& at : comparison.miss.at) seen.push_back(at.body.origin);
  const PlaneWindow window(comparison_scene, seen, margin);
  svg.begin_clip(comparison_scene.corner(), comparison_scene.width, comparison_scene.height);
  draw_grid(svg, window);
  draw_body(svg, window, bars, origin);
  draw_traced_path(svg, window, path, true);
  draw_bars(svg, window, bars);
  for (std::size_t j = 0; j < comparison.target.poses.size(); ++j)
    draw_pose(svg, window, comparison.target.poses[j], j + 1, j == 0);
  draw_pins(svg, window, bars);
  for (const NearMiss::Nearest& at : comparison.miss.at) {
    const Point there = window.to_px(at.body.origin);
    svg.line(window.to_px(comparison.target.poses[at.pose].origin), there, stroke(palette::bad, 2));
    constexpr double arm = 40;
    svg.line(there, there + arm * std::conj(direction(at.body.angle)), stroke(palette::bad, 1.4));
  }
  draw_scale_bar(svg, window, {comparison_scene.left + 24, comparison_scene.bottom() - 18}, unit);
  svg.end_group();
}

void draw_pose_strip(SvgCanvas& svg, const PoseComparison& comparison, std::string_view unit) {
  draw_card(svg, comparison_strip, "");
  const PoseFitError& error = comparison.miss.error;
  const auto length = [&](double value) { return fmt::format("{} {}", significant_text(value, 4), unit); };
  const auto angle = [](double radians) { return significant_text(degrees(radians), 3) + "°"; };
  NumberRows positions(svg, comparison_strip.corner() + Point{18, -9}, 400);
  positions.row("root mean square distance", length(error.position_rms));
  positions.row(fmt::format("largest, at pose {}", comparison.position_max_at + 1), length(error.position_max));
  positions.row("root mean square error", length(error.rms));
  NumberRows angles(svg, comparison_strip.corner() + Point{480, -9}, 440);
  angles.row("root mean square turn", angle(error.angle_rms));
  angles.row(fmt::format("largest, at pose {}", comparison.angle_max_at + 1), angle(error.angle_max));
  angles.row("turning length", length(comparison.target.turning_length));
}

void draw_comparison_strip(SvgCanvas& svg, const PathComparison& comparison, std::string_view unit) {
  draw_card(svg, comparison_strip, "");
  const CurveError& error = comparison.path.error;
  const auto length = [&](double value) { return fmt::format("{} {}", significant_text(value, 4), unit); };
  NumberRows distances(svg, comparison_strip.corner() + Point{18, -9}, 400);
  distances.row("root mean square distance", length(error.rms));
  distances.row(fmt::format("largest, at point {}", error.max_at + 1), length(error.max));
  distances.row("root mean square over the diagonal", significant_text(100 * error.rms_over_diagonal, 3) + " %");
  NumberRows path(svg, comparison_strip.corner() + Point{480, -9}, 440);
  path.row("largest distance of the path between the points", length(error.excursion));
  path.row("length of the path over that of the polygon", significant_text(error.path_length_ratio, 4));
  path.row("points", comparison.path.timed ? "at the angles of the crank given" : "in turn, at any time");
}

}  // namespace

std::string draw_comparison(const StoredLinkage& linkage, const PathComparison& comparison) {
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Four-bar linkage" : linkage.title,
                                       fmt::format("compared with {} points", comparison.path.at.size()));
  draw_card(svg, comparison_card, "");
  draw_comparison_scene(svg, comparison, linkage.length_unit);
  draw_comparison_strip(svg, comparison, linkage.length_unit);
  return svg.file();
}

std::string draw_comparison(const StoredLinkage& linkage, const PoseComparison& comparison) {
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Four-bar linkage" : linkage.title,
                                       fmt::format("compared with {} poses", comparison.miss.at.size()));
  draw_card(svg, comparison_card, "");
  draw_pose_scene(svg, comparison, linkage.length_unit);
  draw_pose_strip(svg, comparison, linkage.length_unit);
  return svg.file();
}

}  // namespace linkwright
