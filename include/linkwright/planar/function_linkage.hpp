#pragma once

#include <optional>
#include <vector>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/mechanism/dyad.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/function_task.hpp"

namespace linkwright {

/// A point of the unit frame (input's ground pivot at 0, the output's at 1) where the ground pivots lie as given.
[[nodiscard]] Homogeneous on_ground(Homogeneous unit, Point input_pivot, Point output_pivot);

/// The four-bar of a coupler: a dyad of the unit frame with circle point A on the input and centre point B on the
/// output (FunctionConditions), at the first pair. Nothing where a pivot is at infinity.
[[nodiscard]] std::optional<FourBar> function_four_bar(const Dyad& coupler, Point input_pivot, Point output_pivot);

/// Where the coupler of a four-bar, given at the first pair, is at each pair: its frame has its origin in the input's
/// moving pivot, and angle 0 at the first pair. Derivatives follow from those of the pairs, all orders; second and
/// higher ones are those of the coupler only as far as its length is constant to that order, as it is for a solution.
/// Passing through these poses is generating the pairs.
[[nodiscard]] std::vector<PrescribedPose> coupler_poses(const FourBar& four_bar, const std::vector<AnglePair>& pairs);

/// Worst relative change of the coupler's length over the pairs.
[[nodiscard]] double coupler_residual(const FourBar& four_bar, const std::vector<AnglePair>& pairs);

}  // namespace linkwright
