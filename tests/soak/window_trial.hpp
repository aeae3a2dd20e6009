#pragma once

#include <string>
#include <vector>

#include "draw.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::soak {

/// Small windows round the hinges of a linkage of the answer that is known to meet the requirements, by a thousandth to
/// a twentieth of the linkage's size: the task is solved anew with them. A finding where nothing is listed, although
/// that linkage stands there. Nothing where the answer holds no linkage.
[[nodiscard]] std::vector<std::string> wrongs_in_windows(const Problem& problem, const Answer& answer, Draw& draw);

}  // namespace linkwright::soak
