#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// As draw_answer(const Problem&, const Answer&): the best linkage with its line, Ball's point and inflection circle;
/// the map; the deviation from the line, magnified; the numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const StraightLineAnswer& answer);

}  // namespace linkwright
