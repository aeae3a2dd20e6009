#include "linkwright/attitude/common_normal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

/// Of unit directions u, v and the vector between the lines' points; the lines are not parallel.
CommonNormal crossing_normal(Vector3 first, Vector3 u, Vector3 second, Vector3 v) {
  const Vector3 n = cross(u, v), between = second - first;
  const double sine_squared = dot(n, n);
  CommonNormal normal;
  const double height = dot(between, normalized(n));
  normal.direction = height < 0 ? -normalized(n) : normalized(n);
  normal.distance = std::fabs(height);
  normal.foot_on_first = first + (determinant(between, v, n) / sine_squared) * u;
  normal.foot_on_second = second + (determinant(between, u, n) / sine_squared) * v;
  normal.twist = std::atan2(dot(normal.direction, n), dot(u, v));
  return normal;
}

CommonNormal parallel_normal(Vector3 first, Vector3 u, Vector3 second, Vector3 v) {
  const Vector3 between = second - first, across = between - dot(between, v) * v;
  CommonNormal normal;
  const double size = std::max({norm(first), norm(second), norm(between)});
  const bool coincide = norm(across) <= tolerance::coincident_lines * size;
  normal.lines = coincide ? LinePair::coincident : LinePair::parallel;
  normal.direction = coincide ? any_normal(u) : normalized(across);
  normal.foot_on_first = first;
  normal.foot_on_second = coincide ? first : first + across;
  normal.distance = coincide ? 0 : norm(across);
  normal.twist = std::atan2(dot(normal.direction, cross(u, v)), dot(u, v));
  return normal;
}

}  // namespace

std::optional<Error> mistake_in(const Line& line, std::string place) {
  if (!is_finite(line.point) || !is_finite(line.direction))
    return Error{"not_finite", std::move(place), "a coordinate is not a number or infinite: give finite numbers"};
  if (line.direction == Vector3{})
    return Error{"zero_direction", std::move(place),
                 "the direction is the null vector, which has no direction: give any other length"};
  return std::nullopt;
}

Vector3 any_normal(Vector3 a) {
  const Vector3 u = normalized(a);
  const double x = std::fabs(u.x), y = std::fabs(u.y), z = std::fabs(u.z);
  const Vector3 least = x <= y && x <= z ? Vector3{1, 0, 0} : y <= z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
  return normalized(cross(u, least));
}

Result<CommonNormal> common_normal(const Line& first, const Line& second) {
  if (auto mistake = mistake_in(first, "first")) return *mistake;
  if (auto mistake = mistake_in(second, "second")) return *mistake;
  const Vector3 u = normalized(first.direction), v = normalized(second.direction);
  const bool parallel = norm(cross(u, v)) <= tolerance::parallel_lines;
  CommonNormal normal =
      parallel ? parallel_normal(first.point, u, second.point, v) : crossing_normal(first.point, u, second.point, v);
  if (!is_finite(normal.foot_on_first) || !is_finite(normal.foot_on_second))
    return Error{"lines_too_far_apart", "first",
                 "the lines lie farther apart than numbers reach: take a larger unit of length"};
  return normal;
}

}  // namespace linkwright
