#pragma once

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "warnings.hpp"

namespace linkwright {

/// What is known of a six-bar task without mistakes before linkages are looked for.
[[nodiscard]] SixBarAnswer begin_answer(const SixBarTask& task, const Requirements& requirements,
                                        const SynthesisOptions& options, const Progress& progress = {});

/// Everything found for a six-bar task without mistakes: with a chain the map over both added links and its best,
/// without one the best of a search. A search that is cancelled answers with the best so far; a map says that it was
/// cancelled.
[[nodiscard]] Result<Answer> solve_of_kind(const SixBarTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);

}  // namespace linkwright
