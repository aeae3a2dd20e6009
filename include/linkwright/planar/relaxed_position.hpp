#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose_error.hpp"
#include "linkwright/planar/four_bar_solution.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The task without one of its poses, and that pose as one that need not be passed exactly; `pose` counts the task's
/// poses from 0. `size` in RelaxedPose is the characteristic length L of the whole task.
struct RelaxedTask {
  MotionTask task;
  RelaxedPose relaxed;
};
/// `pose` has no derivatives.
[[nodiscard]] RelaxedTask relaxed_task(const MotionTask& task, std::size_t pose);

/// The combined position and orientation error of each cell that passes a map's requirements (no bit of its
/// `failures`), user's unit; −1 of the others. `family` of the task without the relaxed pose, `map` over two axes of
/// dyads; `values` has a place for each cell. About 3 µs a passing cell and thread; 0 threads: as many as the machine
/// has. Cells left out because `progress` was cancelled are −1 too.
void pose_errors(const FourBarFamily& family, const RegionMap& map, std::span<const FailureBits> failures,
                 const RelaxedPose& relaxed, std::span<float> values, int threads = 0, const Progress& progress = {});

/// The alternative to a five-position task when one of its poses is relaxed.
struct RelaxedPosition {
  std::size_t pose = 0;  ///< which one, counted from 0
  /// The four-bar through the others that meets the requirements and comes nearest to the relaxed pose. It lies in the
  /// first of the poses that are left. Nothing: `reason` tells.
  std::optional<FourBarSolution> linkage;
  PoseError pose_error;
  double combined = 0;            ///< PoseError::combined with the characteristic length of the whole task, user's unit
  std::int64_t meeting = 0;       ///< four-bars of the map that meet the requirements
  std::optional<MapPoint> place;  ///< of the linkage on the map of the task without the pose
  std::optional<Notice> reason;   ///< degeneracy of the task that is left, no_pair, none_defect_free, none_left
};

struct RelaxedPositionOptions {
  int region_samples = 160;  ///< N of each N×N map
  int starts = 6;            ///< number of cells of a map from which the error is minimised
  /// Least transmission angle (radians) that is asked for beyond the requirements, wherever a linkage has it: the
  /// nearest of all lies at the edge of what is allowed.
  double usable_transmission_angle = pi / 9;
  RegionOptions region;
};

/// For each pose of a five-position task that counts as one position: the nearest that a usable four-bar through the
/// other four comes to it. Nearest first, those without a linkage last. Where two dyads through all five make a usable
/// four-bar, its miss is 0. `task` without mistakes (mistakes_in), of five positions. Cancelled: those that are done.
[[nodiscard]] std::vector<RelaxedPosition> drop_one_position(const MotionTask& task, const Requirements& requirements,
                                                             const RelaxedPositionOptions& options = {},
                                                             const Progress& progress = {});

}  // namespace linkwright
