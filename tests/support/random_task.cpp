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

std::vector<PrescribedPose> moved(const std::vector<PrescribedPose>& poses, double scale, double angle, Point shift) {
  std::vector<PrescribedPose> result = poses;
  for (PrescribedPose& pose : result) {
    pose.pose.origin = scale * direction(angle) * pose.pose.origin + shift;
    pose.pose.angle += angle;
  }
  return result;
}

}  // namespace linkwright::testing
