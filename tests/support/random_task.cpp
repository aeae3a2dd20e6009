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

namespace {

PrescribedPose disturbed(std::mt19937_64& random, const Pose& pose, double deviation) {
  const Point aside{uniform(random, -1, 1), uniform(random, -1, 1)};
  return {{pose.origin + deviation * aside, pose.angle + deviation * uniform(random, -1, 1)}, {}};
}

}  // namespace

std::vector<PrescribedPose> nearly_common_pole(std::mt19937_64& random, double deviation) {
  const Point pole{0.4 + uniform(random, -0.1, 0.1), -0.7 + uniform(random, -0.1, 0.1)}, arm{0.9, 0.8};
  std::vector<PrescribedPose> poses;
  for (const double angle : {0.0, 0.5, 1.1, 1.6})
    poses.push_back(disturbed(random, {pole + direction(angle) * arm, angle}, deviation));
  return poses;
}

std::vector<PrescribedPose> nearly_mirrored(std::mt19937_64& random, double deviation) {
  const Point inner{uniform(random, 0.2, 0.6), uniform(random, -0.4, 0.4)};
  const Point outer{uniform(random, 0.8, 1.5), uniform(random, -0.8, 0.8)};
  const double inner_angle = uniform(random, 0.2, 0.5), outer_angle = uniform(random, 0.7, 1.2);
  std::vector<PrescribedPose> poses;
  for (const Pose& pose : {Pose{-std::conj(outer), -outer_angle}, Pose{-std::conj(inner), -inner_angle},
                           Pose{inner, inner_angle}, Pose{outer, outer_angle}})
    poses.push_back(disturbed(random, pose, deviation));
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
