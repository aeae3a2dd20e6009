#include "support/random_task.hpp"

#include <cmath>

namespace linkwright::testing {

double uniform(std::mt19937_64& random, double low, double high) {
  // The standard distributions differ from machine to machine.
  return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

std::vector<PrescribedPose> random_poses(std::mt19937_64& random, int count) {
  std::vector<PrescribedPose> poses;
  for (int i = 0; i < count; ++i)
    poses.push_back({{{uniform(random, -2, 2), uniform(random, -2, 2)}, uniform(random, -3, 3)}, {}});
  return poses;
}

std::vector<PrescribedPose> random_poses(std::mt19937_64& random, const std::vector<int>& multiplicities) {
  std::vector<PrescribedPose> poses = random_poses(random, static_cast<int>(multiplicities.size()));
  for (std::size_t j = 0; j < poses.size(); ++j)
    for (int m = 1; m < multiplicities[j]; ++m)
      poses[j].derivatives.push_back({{uniform(random, -2, 2), uniform(random, -2, 2)}, uniform(random, -2, 2)});
  return poses;
}

MotionTask motion_task(const std::vector<Pose>& poses) {
  MotionTask task;
  for (const Pose& pose : poses) task.poses.push_back({pose, {}});
  return task;
}

const std::vector<std::vector<int>>& mixed_patterns() {
  static const std::vector<std::vector<int>> patterns = {{2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {2, 2}, {3, 1}, {1, 3}, {4}};
  return patterns;
}

std::vector<PrescribedPose> moved(const std::vector<PrescribedPose>& poses, double scale, double angle, Point shift) {
  std::vector<PrescribedPose> result = poses;
  for (PrescribedPose& pose : result) {
    pose.pose.origin = scale * direction(angle) * pose.pose.origin + shift;
    pose.pose.angle += angle;
    for (PoseDerivative& derivative : pose.derivatives) derivative.origin *= scale * direction(angle);
  }
  return result;
}

}  // namespace linkwright::testing
