#pragma once

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "warnings.hpp"

namespace linkwright {

/// Everything found for a task of four-bars, in the plane or on the sphere, without mistakes; what driving does not
/// confirm is still among it. Cancelled: an error.
[[nodiscard]] Result<Answer> solve_of_kind(const MotionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const FunctionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const SphericalMotionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const SphericalFunctionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);

}  // namespace linkwright
