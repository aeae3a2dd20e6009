#pragma once

#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/function_task.hpp"

namespace linkwright {

/// Where the coupler of a four-bar, given at the first pair, is at each pair: its frame has its origin in the input's
/// moving pivot, and angle 0 at the first pair. Derivatives of all orders follow from those of the pairs; second and
/// higher ones are those of the coupler only as far as its length is constant to that order, as it is for a solution.
/// Passing through these poses is generating the pairs.
[[nodiscard]] std::vector<PrescribedPose> coupler_poses(const FourBar& four_bar, const std::vector<AnglePair>& pairs);

/// Worst relative change of the coupler's length over the pairs.
[[nodiscard]] double coupler_residual(const FourBar& four_bar, const std::vector<AnglePair>& pairs);

}  // namespace linkwright
