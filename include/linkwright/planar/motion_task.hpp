#pragma once

#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Motion generation: a body shall pass through these poses, in this order. A pose with m derivatives (its direction of
/// travel, then its curvature, …) counts as m + 1 positions; their patterns are P-P-P-P, PP-P-P, P-PP-P, P-P-PP, PP-PP,
/// PPP-P, P-PPP and PPPP.
struct MotionTask {
  std::vector<PrescribedPose> poses;
};

/// Largest coordinate (user's unit), angle (degrees) and derivative that is taken seriously.
inline constexpr double largest_coordinate = 1e9;

/// A first derivative none of whose three numbers is this large is zero: no direction.
inline constexpr double smallest_direction = 1e-9;

/// The caller's mistakes in a four-position task: count, numbers that are not finite or too large, first derivatives
/// that are zero, repeated poses. Places are `task.poses[i]…` (i from 0). Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const MotionTask& task);

}  // namespace linkwright
