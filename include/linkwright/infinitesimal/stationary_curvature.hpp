#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/infinitesimal/instant.hpp"

namespace linkwright {

/// A point of the body and the centre of curvature of its path, fixed frame; either may be at infinity.
struct CurvaturePair {
  Homogeneous moving, center;
};

/// The pair on the ray from the pole at an angle ψ to the pole tangent (radians) whose path has four-point contact with
/// its circle of curvature: the circling-point curve (x² + y²)(m x + n y) = x y and, by Euler and Savary, the
/// centering-point curve. Over ψ in [0, π) the two curves are complete but for the pole, where both have a node; where
/// m or n vanishes also but for the pole normal or the pole tangent, which then are a part of each.
[[nodiscard]] CurvaturePair stationary_pair(const TurningInstant& instant, double ray_angle);

/// Centre of curvature of the point at distance r (signed, of the ray's sense) on the ray at ψ, by Euler and Savary:
/// its distance r D sin ψ / (D sin ψ − r).
[[nodiscard]] Homogeneous conjugate_center(const TurningInstant& instant, double ray_angle, double distance);

/// Ball's point: the inflection point whose path has four-point contact with its tangent; fixed frame. Nothing where
/// a3 = b3 = 0 (to tolerance::vanishing_motion of D): the cubic passes through the inflection circle's points
/// nowhere but at the pole.
[[nodiscard]] std::optional<Point> ball_point(const TurningInstant& instant);

/// Burmester's points: four at most, whose paths have five-point contact with their circles of curvature; those of a
/// four-bar's coupler include its moving pivots. By the quartic over tan ψ (theory: docs/theory/infinitesimal.md), each
/// polished on the conditions of the second, third and fourth order. Needs the fourth order.
[[nodiscard]] std::vector<CurvaturePair> burmester_points_at(const TurningInstant& instant);

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
