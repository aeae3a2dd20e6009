#pragma once

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// All linkages that do a task. A map that is cancelled is an error; a search that is cancelled answers with the best
/// so far.
[[nodiscard]] Result<Answer> solve(const Task& task, const Requirements& requirements, const SynthesisOptions& options,
                                   const Progress& progress = {});

}  // namespace linkwright
