#pragma once

#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/planar/motion_task.hpp"

namespace linkwright {

/// Of what a task says of near poses: as mistakes_in().
[[nodiscard]] std::vector<Error> mistakes_in_near(const MotionTask& task);

}  // namespace linkwright
