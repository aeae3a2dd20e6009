#pragma once

#include <array>
#include <string>
#include <string_view>

#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/planar/motion_task.hpp"

namespace linkwright::bench {

/// The tasks that are timed: a curve of two branches, one of a single branch, and the gallery's tailgate.
inline constexpr std::array<std::string_view, 3> task_names = {"landing_gear", "drawer_hinge", "tailgate"};

[[nodiscard]] MotionTask task_named(std::string_view name);

/// A task's Burmester curve, sampled: both axes of its region.
struct SampledTask {
  DyadAxis axis;
  double unit;  ///< characteristic length, user's unit
};
[[nodiscard]] SampledTask sampled(std::string_view name, int samples);

/// The axis and the kernel's counts over it as JSON, for the peers (bench/peers).
[[nodiscard]] std::string dump(std::string_view name, int samples);

/// Random tasks of five poses and their Burmester points (circle, centre; working frame) as JSON, for PHCpack.
[[nodiscard]] std::string dump_five(int count);

}  // namespace linkwright::bench
