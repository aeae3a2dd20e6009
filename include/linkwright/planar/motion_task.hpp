#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/body_points.hpp"
#include "linkwright/planar/three_pose_given.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// A line on which a grounded link is to have a pivot; a moving one as it lies in position 1.
struct PivotOnLine {
  Side side = Side::input;
  PivotKind pivot = PivotKind::ground;
  LineAtAngle line;  ///< user's unit
  friend bool operator==(const PivotOnLine&, const PivotOnLine&) = default;
};

/// A pose that a body is to pass as near as it can, among others that it passes exactly or as near.
struct NearPose {
  /// How far off the body may be there.
  struct Tolerance {
    std::optional<double> position;  ///< of its origin, user's unit, > 0
    std::optional<double> angle;     ///< radians, > 0
    friend bool operator==(const Tolerance&, const Tolerance&) = default;
  };

  Pose pose;
  std::size_t after = 0;  ///< how many of the task's `poses` come before it
  std::optional<Tolerance> tolerance;
  std::optional<double> weight;  ///< of the squared error, ≥ 0; nothing: 1
  friend bool operator==(const NearPose&, const NearPose&) = default;
};

/// Motion generation: a body shall pass through these poses, in this order. A pose with m derivatives (its direction of
/// travel, then its curvature, …) counts as m + 1 positions; there are three, four or five of them, in any pattern from
/// P-P-P to PPPPP.
struct MotionTask {
  static constexpr OutputKind output = OutputKind::pose;

  std::vector<PrescribedPose> poses;
  std::optional<ThreePoseGiven> given;  ///< three positions: what else is known; otherwise nothing
  /// Of five positions, the pose (index) that need not be passed exactly: the others are a task of four, and the
  /// error of a linkage at this one is reported.
  std::optional<std::size_t> relaxed;
  std::vector<PivotOnLine> pivots_on;  ///< four positions: at most one to each grounded link; otherwise none
  std::vector<BodyPoints> points;      ///< what the poses were given by, in their order; empty: by themselves

  std::vector<NearPose> near;  ///< `after` never falls
  /// Of near poses: by it an error of angle weighs as one of position, user's unit, > 0; nothing: the characteristic
  /// length of all poses.
  std::optional<double> turning_length;

  static constexpr std::size_t most_near = 1000;

  [[nodiscard]] const LinkageClass& linkage_class() const {
    return near.empty() ? planar_linkages : near_motion_linkages;
  }
  /// Too few positions are exact for a map of all linkages that pass them: linkages are searched for.
  [[nodiscard]] bool is_fitted() const;

  friend bool operator==(const MotionTask&, const MotionTask&) = default;
};

/// Of poses in the order of a task's file: which are the exact ones, and which near.
struct TaskPlace {
  bool is_near = false;
  std::size_t index = 0;  ///< among the exact, or the near ones
};
/// One to each pose, exact or near, in their order.
[[nodiscard]] std::vector<TaskPlace> places_of(const MotionTask& task);
/// All, likewise.
[[nodiscard]] std::vector<PrescribedPose> all_poses(const MotionTask& task);

/// The caller's mistakes: number of positions, numbers that are not finite or too large, first derivatives that are
/// zero, repeated poses, what three positions want given and more do not. Places are `task.poses[i]…` (i from 0),
/// `task.given…` and `task.pivot_on[i]…`. Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const MotionTask& task);

}  // namespace linkwright
