#pragma once

#include <cstdint>
#include <vector>

#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// Where one pose of a task may go: how many cells of a coarse map meet the requirements after it has moved. Tasks that
/// are refused or degenerate count 0. Where no max_length is given, each moved task has its own default.
class FeasibleOffsets {
 public:
  /// `task` without mistakes; maps of `samples` × `samples` cells.
  FeasibleOffsets(MotionTask task, Requirements requirements, Spacing spacing, int samples);

  /// Pose `pose` (from 0) moved by a grid of steps × steps offsets, evenly over ±reach (user's unit) in x and y;
  /// row-major [dy][dx], both rising.
  [[nodiscard]] std::vector<std::uint32_t> moved(std::size_t pose, double reach, int steps) const;
  /// Pose `pose` turned about its origin by `steps` angles, evenly over ±reach (radians), rising.
  [[nodiscard]] std::vector<std::uint32_t> turned(std::size_t pose, double reach, int steps) const;

 private:
  MotionTask task_;
  Requirements requirements_;
  Spacing spacing_;
  int samples_;
};

/// The offsets of a halo: `steps` values evenly over ±reach; 0 alone for a single step.
[[nodiscard]] std::vector<double> offset_values(double reach, int steps);

}  // namespace linkwright
