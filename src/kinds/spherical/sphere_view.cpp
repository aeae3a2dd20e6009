#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "spherical_figure.hpp"

namespace linkwright {
namespace {

constexpr double longest_step = radians(3);

/// A unit vector across another one, along `wanted` as far as that is possible.
Vector3 unit_across(Vector3 axis, Vector3 wanted) {
  const Vector3 rest = wanted - dot(wanted, axis) * axis;
  if (norm(rest) > 1e-6) return normalized(rest);
  const Vector3 other = std::fabs(axis.x) < 0.9 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  return normalized(cross(axis, other));
}

}  // namespace

SphereView::SphereView(Point center, double radius, Vector3 towards, Vector3 right)
    : center_(center),
      radius_(radius),
      towards_(towards),
      right_(unit_across(towards, right)),
      up_(cross(towards_, right_)) {}

SphereView::Pieces SphereView::pieces(std::span<const Vector3> path) const {
  Pieces cut;
  bool was_in_front = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool in_front = is_in_front(path[i]);
    auto& side = in_front ? cut.front : cut.back;
    if (i == 0 || in_front != was_in_front) {
      side.emplace_back();
      if (i > 0) {
        const double before = std::fabs(dot(path[i - 1], towards_)), after = std::fabs(dot(path[i], towards_));
        const double share = before + after > 0 ? before / (before + after) : 0;
        const Point rim = to_px(normalized((1 - share) * path[i - 1] + share * path[i]));
        (in_front ? cut.back : cut.front).back().push_back(rim);
        side.back().push_back(rim);
      }
    }
    side.back().push_back(to_px(path[i]));
    was_in_front = in_front;
  }
  return cut;
}

std::vector<Vector3> great_arc(Vector3 from, Vector3 to) {
  const double angle = angle_between(from, to);
  const int steps = std::max(1, static_cast<int>(std::ceil(angle / longest_step)));
  const Vector3 across = unit_across(from, to);
  std::vector<Vector3> arc;
  for (int i = 0; i <= steps; ++i) {
    const double along = angle * i / steps;
    arc.push_back(std::cos(along) * from + std::sin(along) * across);
  }
  return arc;
}

std::vector<Vector3> great_circle(Vector3 normal) {
  const Vector3 from = unit_across(normal, {1, 0, 0}), across = cross(normal, from);
  constexpr int sides = 120;
  std::vector<Vector3> circle;
  for (int i = 0; i <= sides; ++i) {
    const double along = two_pi * i / sides;
    circle.push_back(std::cos(along) * from + std::sin(along) * across);
  }
  return circle;
}

}  // namespace linkwright
