#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/three_pose_given.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// Motion generation: a body shall pass through these poses, in this order. A pose with m derivatives (its direction of
/// travel, then its curvature, …) counts as m + 1 positions; there are three, four or five of them, in any pattern from
/// P-P-P to PPPPP.
struct MotionTask {
  static constexpr const LinkageClass& linkages = planar_linkages;

  std::vector<PrescribedPose> poses;
  std::optional<ThreePoseGiven> given;  ///< three positions: what else is known; otherwise nothing
  /// Of five positions, the pose (index) that need not be passed exactly: the others are a task of four, and the
  /// error of a linkage at this one is reported.
  std::optional<std::size_t> relaxed;

  friend bool operator==(const MotionTask&, const MotionTask&) = default;
};

/// The caller's mistakes: number of positions, numbers that are not finite or too large, first derivatives that are
/// zero, repeated poses, what three positions want given and more do not. Places are `task.poses[i]…` (i from 0) and
/// `task.given…`. Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const MotionTask& task);

}  // namespace linkwright
