#pragma once

#include <array>

#include "linkwright/infinitesimal/motion_series.hpp"

namespace linkwright {

/// How the path of a point runs beside a line through where it is now.
struct LineContact {
  /// e(s) = Σ deviation[k] s^k: signed distance to the left of the line, by the way along it; user's unit.
  std::array<double, motion_order + 1> deviation{};
  /// Points that path and line have in common here: the power of the first term of e, by the motion's parameter, that
  /// does not vanish to tolerance::vanishing_deviation of what it is made of; one more than the motion's order where
  /// none of those known is left; 0 where the point rests now (a cusp: there is no such series).
  int points = 0;
};

/// Of a point of the moving body with the line through it along `direction` (unit vector).
[[nodiscard]] LineContact contact_with_line(const MotionSeries& motion, Point point, Point direction);

}  // namespace linkwright
