#pragma once

#include "linkwright/planar/motion_task.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright::testing {

/// The task and the wishes of examples/tailgate.json.
[[nodiscard]] MotionTask tailgate_task();
[[nodiscard]] Requirements tailgate_requirements();

}  // namespace linkwright::testing
