#pragma once

#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Motion generation: a body shall pass through these poses, in this order.
struct MotionTask {
  std::vector<PrescribedPose> poses;
};

/// Largest coordinate (user's unit) and angle (degrees) that is taken seriously.
inline constexpr double largest_coordinate = 1e9;

/// The caller's mistakes in a four-position task: count, numbers that are not finite or too large, repeated poses.
/// Places are `task.poses[i]…` (i from 0). Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const MotionTask& task);

}  // namespace linkwright
