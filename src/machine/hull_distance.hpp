#pragma once

#include <span>

#include "linkwright/algebra/vector3.hpp"

namespace linkwright {

/// Least distance of the convex hulls of two sets of one to four points in the plane z = 0; 0 where they meet.
[[nodiscard]] double hull_distance(std::span<const Vector3> one, std::span<const Vector3> other);

/// Least angle, radians, of two arcs of great circles shorter than half a turn, each given by the unit vectors of its
/// ends (or by one alone, a point); 0 where they cross.
[[nodiscard]] double arc_distance(std::span<const Vector3> one, std::span<const Vector3> other);

}  // namespace linkwright
