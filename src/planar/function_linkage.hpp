#pragma once

#include <span>
#include <vector>

#include "linkwright/function/function_error.hpp"
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

/// What a four-bar that stands at `first` generates.
[[nodiscard]] GeneratedFunction generated_function(const FourBar& four_bar, const AnglePair& first);

/// How well a four-bar, given at the first of the pairs, generates them and the function.
[[nodiscard]] FunctionError function_error(const FourBar& four_bar, std::span<const AnglePair> pairs,
                                           const ScaledFunction* function, const ErrorSampling& sampling = {});

/// The same of a task: builds its function anew; of many linkages of a family, FunctionFamily::error_of() is quicker.
[[nodiscard]] FunctionError function_error(const FourBar& four_bar, const FunctionTask& task,
                                           const ErrorSampling& sampling = {});

}  // namespace linkwright
