#pragma once

#include <variant>
#include <vector>

#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright {

/// What a planar linkage is asked to do: guide a body by a four-bar, generate a function by a four-bar, guide a body by
/// a six-bar.
using Task = std::variant<MotionTask, FunctionTask, SixBarTask>;

/// What the linkages of a kind of task can be, and what can be asked of them.
[[nodiscard]] const LinkageClass& linkages(const Task& task);

/// The caller's mistakes, as of the kind of task.
[[nodiscard]] std::vector<Error> mistakes_in(const Task& task);

}  // namespace linkwright
