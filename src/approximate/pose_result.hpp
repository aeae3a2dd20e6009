#pragma once

#include <span>

#include "approximate/body_linkage.hpp"
#include "approximate/fit_limits.hpp"
#include "linkwright/approximate/pose_fit.hpp"

namespace linkwright {

/// All that is told of a linkage by its states at the poses of a target; user's frame and unit. Its input drives.
[[nodiscard]] PoseFit pose_fit_of(const BodyLinkage& linkage, std::span<const BodyPose> states,
                                  const PoseTarget& target, const PoseFitOptions& options);

/// What the options ask for, where a scale of the target is `scale`. Windows are left out: they have a frame.
[[nodiscard]] FitLimits limits_of(const PoseFitOptions& options, double scale);

}  // namespace linkwright
