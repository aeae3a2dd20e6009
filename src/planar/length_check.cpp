#include "planar/length_check.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {

LengthCheck::LengthCheck(std::span<const PrescribedPose> poses) : first_origin_(poses.front().pose.origin) {
  for (const auto& [pose, derivatives] : poses.subspan(1))
    moves_.push_back({direction(pose.angle - poses.front().pose.angle), pose.origin});
}

double LengthCheck::residual(Point center, Point circle) const {
  const auto distance = [](Point d) { return std::sqrt(std::norm(d)); };  // hypot takes four times as long
  const double length = distance(circle - center);
  const Point in_body = circle - first_origin_;
  double worst = 0;
  for (const Move& move : moves_)
    worst = std::max(worst, std::abs(distance(move.origin + move.turn * in_body - center) - length));
  return worst / length;
}

}  // namespace linkwright
