#pragma once

#include <span>
#include <variant>
#include <vector>

#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/path_task.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "linkwright/spherical/spherical_function_task.hpp"
#include "linkwright/spherical/spherical_motion_task.hpp"
#include "linkwright/straight_line/straight_line_task.hpp"

namespace linkwright {

/// What a linkage is asked to do: guide a body by a planar four-bar, generate a function by one, guide a body by a
/// planar six-bar, guide a body about a fixed centre or generate a function by a spherical four-bar, guide a point
/// along a line by a planar four-bar, or through places at given angles of its crank.
using Task = std::variant<MotionTask, FunctionTask, SixBarTask, SphericalMotionTask, SphericalFunctionTask,
                          StraightLineTask, PathTask>;

/// What the linkages of a kind of task can be, and what can be asked of them.
[[nodiscard]] const LinkageClass& linkages(const Task& task);

[[nodiscard]] OutputKind output_kind(const Task& task);

/// The poses of the body that the task guides in the plane; none where it guides none there.
[[nodiscard]] std::span<const PrescribedPose> guided_poses(const Task& task);
/// The points by which they were given; none: by themselves.
[[nodiscard]] std::span<const BodyPoints> points_of(const Task& task);

/// The function that a task asks for; null where it asks for none.
[[nodiscard]] const WantedFunction* wanted_function(const Task& task);

/// Whether chance draws linkages, of which the best are kept: the answer has no map that could be counted.
[[nodiscard]] bool is_search(const Task& task);

/// The caller's mistakes, as of the kind of task.
[[nodiscard]] std::vector<Error> mistakes_in(const Task& task);

}  // namespace linkwright
