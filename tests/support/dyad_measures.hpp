#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/burmester_points.hpp"

namespace linkwright::testing {

/// Sum of the sines between the two dyads' points, as unit vectors.
[[nodiscard]] inline double apart(const Dyad& a, const Dyad& b) {
  return norm(cross(normalized(a.circle), normalized(b.circle))) +
         norm(cross(normalized(a.center), normalized(b.center)));
}

/// The distance of a dyad from the nearest of the points.
[[nodiscard]] inline double nearest(const BurmesterPoints& found, const Dyad& wanted) {
  double best = 2;
  for (const BurmesterPoint& point : found.points) best = std::min(best, apart(point.dyad, wanted));
  return best;
}

/// Worst change of a grounded link's length over the finite poses, relative to the length.
[[nodiscard]] inline double relative_length_change(const std::vector<PrescribedPose>& poses, Point center,
                                                   Point circle) {
  const double length = std::abs(circle - center);
  double worst = 0;
  for (const PrescribedPose& pose : poses)
    worst = std::max(worst, std::abs(std::abs(displaced(circle, poses[0].pose, pose.pose) - center) / length - 1));
  return worst;
}

}  // namespace linkwright::testing
