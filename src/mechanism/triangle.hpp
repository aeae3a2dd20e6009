#pragma once

#include <algorithm>
#include <cmath>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/four_bar.hpp"

/// The triangle in which a four-bar's position analysis lies: coupler, output link, and the diagonal that joins the
/// input's moving pivot to the output's centre.
namespace linkwright {

/// Four bars of finite, positive length (false for NaN).
[[nodiscard]] inline bool are_links(const LinkLengths& l) { return std::isfinite(l.perimeter()) && l.shortest() > 0; }

/// Error of a diagonal that is taken for rounding, user's unit.
[[nodiscard]] inline double diagonal_slack(const LinkLengths& l) { return tolerance::dead_point * l.perimeter(); }

/// From the output's centre to the input's moving pivot, in the four-bar's own frame. By the half angle, so that it
/// keeps its digits where the two nearly meet.
[[nodiscard]] inline Point diagonal(const LinkLengths& l, double input_angle) {
  const double half_sine = std::sin(input_angle / 2);
  return {(l.input - l.ground) - 2 * l.input * half_sine * half_sine, l.input * std::sin(input_angle)};
}

/// Of two lines that enclose this angle, in [0, π].
[[nodiscard]] inline double acute(double angle) { return std::min(angle, pi - angle); }

/// x + y − z, exact to rounding of the result where z is near the larger of x and y.
[[nodiscard]] inline double excess(double x, double y, double z) { return std::min(x, y) - (z - std::max(x, y)); }

/// √x √y, an excess within `slack` of zero, or below it, counting as zero.
[[nodiscard]] inline double root_product(double x, double y, double slack) {
  return (x > slack ? std::sqrt(x) : 0) * (y > slack ? std::sqrt(y) : 0);
}

/// The angle, in [0, π], opposite `side` in a triangle, by the half-angle formula
/// tan²(α/2) = (r − p + q)(r + p − q)/((p + q − r)(p + q + r)), accurate for needles
/// (W. Kahan, "Miscalculating area and angles of a needle-like triangle", 2014). A triangle flat within `slack` is
/// flat; one without base (p = 0, r = q) is isosceles.
[[nodiscard]] inline double angle_opposite(double side, double p, double q, double slack) {
  const double rise = root_product(excess(side, q, p), excess(side, p, q), slack);
  const double run = root_product(excess(p, q, side), p + q + side, slack);
  return rise == 0 && run == 0 ? pi / 2 : 2 * std::atan2(rise, run);
}

}  // namespace linkwright
