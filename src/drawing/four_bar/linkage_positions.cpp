#include <algorithm>

#include "linkage_figure.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/defects.hpp"

namespace linkwright {
namespace {

constexpr int fine_samples = 7201;         // near change points a coupler whips round within a degree of the input
constexpr double path_resolution = 0.002;  // of the path's extent: finer than a drawing shows

/// The path without points that lie closer to the last one than can be seen; the ends stay.
std::vector<Point> thinned_path(const std::vector<Point>& path) {
  double extent = 0;
  for (const Point p : path) extent = std::max(extent, std::abs(p - path.front()));
  std::vector<Point> kept;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == path.size();
    if (is_end || std::abs(path[i] - kept.back()) >= path_resolution * extent) kept.push_back(path[i]);
  }
  return kept;
}

std::vector<Point> traced_points(std::span<const MotionState> motion) {
  std::vector<Point> path;
  path.reserve(motion.size());
  for (const MotionState& state : motion) path.push_back(state.coupler_point);
  return path;
}

}  // namespace

FourBar in_pose(const FourBar& four_bar, std::span<const PrescribedPose> poses, std::size_t pose) {
  FourBar bars = four_bar;
  const Pose &from = poses.front().pose, &to = poses[pose].pose;
  bars.input_moving = displaced(bars.input_moving, from, to);
  bars.output_moving = displaced(bars.output_moving, from, to);
  return bars;
}

std::vector<FourBar> in_positions(const StoredLinkage& linkage) {
  std::vector<FourBar> bars;
  for (std::size_t pose = 0; pose < linkage.poses.size(); ++pose)
    bars.push_back(in_pose(linkage.four_bar, linkage.poses, pose));
  for (const CycleState& state : tabulated_cycle(linkage))
    if (state.pose > 0) bars[static_cast<std::size_t>(state.pose)] = state.four_bar;
  return bars;
}

std::vector<Point> path_of_task(const FourBar& four_bar, std::span<const PrescribedPose> poses, Point traced) {
  if (poses.size() < 2) return {};
  // In the direction that the poses want; where they cannot have that, the task may not ask for it.
  DefectReport report = find_defects(four_bar, poses, true);
  if (report.sense == DriveSense::none) report = find_defects(four_bar, poses, false);
  if (report.sense == DriveSense::none) return {};
  const double sweep = report.sense == DriveSense::cw ? -report.sweep : report.sweep;
  return thinned_path(traced_points(motion_sweep(four_bar, traced, sweep, fine_samples)));
}

std::vector<Point> path_of_cycle(const FourBar& four_bar, Point traced) {
  return thinned_path(traced_points(motion_cycle(four_bar, traced, fine_samples)));
}

}  // namespace linkwright
