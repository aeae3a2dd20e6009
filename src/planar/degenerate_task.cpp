#include "planar/degenerate_task.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// Circle points picked anywhere tell what their centres have in common.
constexpr std::array<Point, 3> probes = {Point{0.3, 0.7}, Point{-1.1, 0.4}, Point{0.6, -0.9}};

// Two conditions are left: they name one centre for each circle point. Nothing where one is at infinity.
std::optional<std::array<Point, 3>> centers_of_probes(const PoseConditions& conditions) {
  if (conditions.rank != 2) return std::nullopt;
  std::array<Point, 3> centers;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Homogeneous circle = Homogeneous::of(probes[i]);
    const auto center = finite_point(cross(circle * conditions.rows[0], circle * conditions.rows[1]));
    if (!center) return std::nullopt;
    centers[i] = *center;
  }
  return centers;
}

bool agree(const std::array<Point, 3>& points) {
  constexpr double same = 1e-6;  // the rank was found to 1e-14 of the rows; centres carry its square root, and room
  return std::abs(points[0] - points[1]) < same && std::abs(points[0] - points[2]) < same;
}

// Rounding next to nothing is nothing.
double tidy(double value, double size) { return std::abs(value) < 1e-9 * size ? 0 : value; }

std::string written(Point p, double size) {
  return fmt::format("({:.6g}, {:.6g})", tidy(p.real(), size), tidy(p.imag(), size));
}

std::string every_point_reason(const PoseConditions& conditions) {
  const auto centers = centers_of_probes(conditions);
  if (centers && agree(*centers)) {
    const Point pole = conditions.frame.to_user((*centers)[0]);
    return fmt::format(
        "All poses are turns about one common pole, {}: every point of the body runs on a circle about it. "
        "One hinge there does the task; no four-bar is needed.",
        written(pole, conditions.frame.scale));
  }
  const auto offset_of = [&](std::size_t i) { return (*centers)[i] - probes[i]; };
  if (centers && conditions.only_translations && agree({offset_of(0), offset_of(1), offset_of(2)})) {
    const Point offset = conditions.frame.scale * offset_of(0);
    return fmt::format(
        "All poses are parallel and their origins lie on one circle: every point of the body is a circle point, its "
        "centre "
        "lies {} from it. Any two make a parallelogram linkage that does the task.",
        written(offset, conditions.frame.scale));
  }
  return "The conditions of the poses depend on each other: the dyads form more than a curve. Move one pose.";
}

}  // namespace

bool are_parallel(const Pose& a, const Pose& b) {
  return std::abs(wrap_signed(a.angle - b.angle)) < tolerance::pure_translation;
}

std::optional<std::string> degeneracy_of(const MotionTask& task, const PoseConditions& conditions,
                                         const BurmesterCurve& curve) {
  if (curve.kind() == CubicKind::every_point) return every_point_reason(conditions);
  const bool parallel = std::all_of(task.poses.begin(), task.poses.end(), [&](const PrescribedPose& pose) {
    return are_parallel(task.poses.front().pose, pose.pose);
  });
  if (parallel)
    return "All poses are parallel and their origins lie on no common circle: the body only shifts, and every dyad has "
           "both "
           "its points at infinity. No four-bar with pivots does this; two sliders at an angle, or a linkage of more "
           "links, do.";
  return std::nullopt;
}

}  // namespace linkwright
