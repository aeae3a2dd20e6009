#pragma once

#include "linkwright/infinitesimal/motion_series.hpp"

namespace linkwright::testing {

/// Powers of the parameter up to which a point's distance from a fixed centre stays: points that its path and that
/// circle have in common.
[[nodiscard]] inline int contact_with_circle(const MotionSeries& motion, Point point, Point center) {
  const auto from_center = motion.path_of(point) - ComplexSeries<motion_order>::constant(center);
  auto mirrored = from_center;
  for (Point& c : mirrored.c) c = std::conj(c);
  const auto square = from_center * mirrored;
  for (std::size_t k = 1; k <= motion_order; ++k)
    if (std::abs(square.c[k]) > 1e-8 * std::norm(point - center)) return static_cast<int>(k);
  return motion_order + 1;
}

}  // namespace linkwright::testing
