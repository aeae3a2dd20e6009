#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// As draw_answer(const Problem&, const Answer&): the map, and what the best linkage generates.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const SphericalFunctionAnswer& answer);

}  // namespace linkwright
