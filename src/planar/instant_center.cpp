#include "instant_center.hpp"

#include <cmath>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

// Root mean square of the way from the first pose; 1 where the body only turns.
double typical_way(const std::vector<PrescribedPose>& poses) {
  double sum = 0;
  for (const PrescribedPose& pose : poses) sum += std::norm(pose.pose.origin - poses.front().pose.origin);
  return sum > 0 ? std::sqrt(sum / static_cast<double>(poses.size() - 1)) : 1;
}

}  // namespace

std::vector<PrescribedPose> with_instant_center(std::vector<PrescribedPose> poses, const InstantCenter& center) {
  require(poses.size() > 1 && poses.front().derivatives.empty(), "the first of several poses is without derivatives");
  constexpr Point quarter_turn{0, 1};
  const Point turning = quarter_turn * (poses.front().pose.origin - center.point);
  if (!center.at_infinity)
    poses.front().derivatives = {{turning, 1}};
  else
    poses.front().derivatives = {{quarter_turn * center.point * (typical_way(poses) / std::abs(center.point)), 0}};
  return poses;
}

}  // namespace linkwright
