#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// As draw_answer(const Problem&, const Answer&): the best six-bar; the map of its chain, or of a search what it has
/// found; the numbers.
[[nodiscard]] std::string draw_sheet(const Problem& problem, const SixBarAnswer& answer);

}  // namespace linkwright
