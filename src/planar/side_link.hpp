#pragma once

#include <span>

#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Worst change of the distance of a fixed point and a point of the body over the poses, as a share of it. `circle` as
/// it lies in the first pose, all in the frame of the poses.
[[nodiscard]] double length_residual(std::span<const PrescribedPose> poses, Point center, Point circle);

}  // namespace linkwright
