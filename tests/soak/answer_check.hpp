#pragma once

#include <string>
#include <vector>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::soak {

/// What an answer says that cannot be, a sentence each; `result` is its text as a result file. Beside the solver's own
/// words only the task is looked at: residuals, lengths and boxes are computed anew from the pivots.
[[nodiscard]] std::vector<std::string> wrongs_of(const Problem& problem, const Answer& answer,
                                                 const std::string& result);

}  // namespace linkwright::soak
