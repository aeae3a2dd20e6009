#pragma once

#include <functional>
#include <vector>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/infinitesimal/instant.hpp"

namespace linkwright {

/// A plane curve in closed pieces, each by the share of its way round in [0, 1); the piece may run through infinity,
/// and then at(share) changes its sign there. Fixed frame.
struct StationaryCurve {
  std::vector<std::function<Homogeneous(double share)>> pieces;
};

/// The points whose paths have stationary curvature now, and the centres of curvature of those paths: cubics with a
/// node at the pole, of which the pole normal or the pole tangent may be a part; equilateral hyperbolas where the body
/// translates. Empty where all points have it: of a body that turns about a point that stays, and of a parallelogram's.
[[nodiscard]] StationaryCurve circling_point_curve(const Instant& instant);
[[nodiscard]] StationaryCurve centering_point_curve(const Instant& instant);

}  // namespace linkwright
