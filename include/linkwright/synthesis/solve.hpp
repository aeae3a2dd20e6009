#pragma once

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/problem.hpp"

namespace linkwright {

/// All linkages that do the problem's task, and the best of them. A map that is cancelled is an error; a search that is
/// cancelled answers with the best so far.
[[nodiscard]] Result<Answer> solve(const Problem& problem, const Progress& progress = {});

}  // namespace linkwright
