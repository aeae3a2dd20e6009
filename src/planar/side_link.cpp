#include "planar/side_link.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {

double length_residual(std::span<const PrescribedPose> poses, Point center, Point circle) {
  const double length = std::abs(circle - center);
  double worst = 0;
  for (const PrescribedPose& pose : poses) {
    const Point moved = displaced(circle, poses.front().pose, pose.pose);
    worst = std::max(worst, std::abs(std::abs(moved - center) - length) / length);
  }
  return worst;
}

}  // namespace linkwright
