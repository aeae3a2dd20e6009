#pragma once

#include <optional>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "warnings.hpp"

namespace linkwright {

/// What is known of a task without mistakes before linkages are looked for.
[[nodiscard]] MotionAnswer begin_answer(const MotionTask& task, const Requirements& requirements,
                                        const SynthesisOptions& options, const Progress& progress = {});
[[nodiscard]] FunctionAnswer begin_answer(const FunctionTask& task, const Requirements& requirements,
                                          const SynthesisOptions& options, const Progress& progress = {});
[[nodiscard]] PathAnswer begin_answer(const PathTask& task, const Requirements& requirements,
                                      const SynthesisOptions& options, const Progress& progress = {});
[[nodiscard]] SphericalMotionAnswer begin_answer(const SphericalMotionTask& task, const Requirements& requirements,
                                                 const SynthesisOptions& options, const Progress& progress = {});
[[nodiscard]] SphericalFunctionAnswer begin_answer(const SphericalFunctionTask& task, const Requirements& requirements,
                                                   const SynthesisOptions& options, const Progress& progress = {});

/// Why there is no map.
template <class... Parts>
[[nodiscard]] Notice no_map(const PairAnswer<Parts...>& known) {
  return known.given.degeneracy.value_or(Notice{"no_map", "There is no map of this task.", {}});
}

/// The linkage at a place of the map, with `verify` driven through; nothing where there is none.
[[nodiscard]] std::optional<FourBarSolution> linkage_at(const FourBarAnswer& answer, MapPoint place,
                                                        bool verify = true);
/// The same with its errors at near poses, which it has to meet in their order, too.
[[nodiscard]] std::optional<FourBarSolution> linkage_at(const MotionAnswer& answer, MapPoint place, bool verify = true);
/// The same with its path; with `verify` its crank turned through the points, too.
[[nodiscard]] std::optional<FourBarSolution> linkage_at(const PathAnswer& answer, MapPoint place, bool verify = true);
[[nodiscard]] std::optional<SphericalSolution> linkage_at(const SphericalAnswer& answer, MapPoint place,
                                                          bool verify = true);

/// How well a linkage of a function's task generates it. Where driving a generator free of defects confirms it, it must
/// also have brought the output to each pair.
void measure_function(FourBarSolution& found, const FunctionFamily& family);
void measure_function(SphericalSolution& found, const SphericalFunctionFamily& family);

/// Everything found for a task of four-bars, in the plane or on the sphere, without mistakes; what driving does not
/// confirm is still among it. Cancelled: an error.
[[nodiscard]] Result<Answer> solve_of_kind(const MotionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const FunctionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const PathTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const SphericalMotionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);
[[nodiscard]] Result<Answer> solve_of_kind(const SphericalFunctionTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);

}  // namespace linkwright
