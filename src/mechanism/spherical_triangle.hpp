#pragma once

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// Of two great circles that enclose this angle, in [0, π].
[[nodiscard]] inline double acute_angle(double angle) { return std::min(angle, pi - angle); }

/// The shorter way between two directions that are an angle in [0, 2π] apart on a great circle.
[[nodiscard]] inline double shorter_arc(double angle) { return angle > pi ? two_pi - angle : angle; }

/// The angle, in [0, π], opposite the arc `side` in a spherical triangle with arcs `p` and `q`, by the half-angle
/// formula tan²(A/2) = sin(s − p) sin(s − q) / (sin s sin(s − side)), 2s = side + p + q. A sine below
/// tolerance::dead_point, or negative, counts as zero: a flat triangle. Where both vanish the angle is free: π/2.
[[nodiscard]] inline double angle_opposite_arc(double side, double p, double q) {
  const auto sine = [](double half) { return half > tolerance::dead_point ? std::sin(half) : 0; };
  const double s = 0.5 * (side + p + q), far = pi - s;
  const double rise = std::sqrt(std::max(0.0, sine(s - p))) * std::sqrt(std::max(0.0, sine(s - q)));
  const double run = std::sqrt(std::max(0.0, far > tolerance::dead_point ? std::sin(s) : 0)) *
                     std::sqrt(std::max(0.0, sine(s - side)));
  return rise == 0 && run == 0 ? pi / 2 : 2 * std::atan2(rise, run);
}

/// Four arcs in (0, π), none without length.
[[nodiscard]] inline bool are_links(const LinkAngles& l) {
  const auto arcs = l.all();
  return std::all_of(arcs.begin(), arcs.end(), [](double arc) { return arc > 0 && arc < pi; });
}

}  // namespace linkwright
