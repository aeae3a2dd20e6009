#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// As draw_answer(): the best four-bar in its task, the solution region, the numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const MotionAnswer& answer);
[[nodiscard]] std::string draw_sheet(const Problem& problem, const FunctionAnswer& answer);

}  // namespace linkwright
