#pragma once

#include <variant>
#include <vector>

#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "linkwright/spherical/spherical_motion_task.hpp"

namespace linkwright {

/// What a linkage is asked to do: guide a body by a planar four-bar, generate a function by one, guide a body by a
/// planar six-bar, guide a body about a fixed centre by a spherical four-bar.
using Task = std::variant<MotionTask, FunctionTask, SixBarTask, SphericalMotionTask>;

/// What the linkages of a kind of task can be, and what can be asked of them.
[[nodiscard]] const LinkageClass& linkages(const Task& task);

/// The caller's mistakes, as of the kind of task.
[[nodiscard]] std::vector<Error> mistakes_in(const Task& task);

}  // namespace linkwright
