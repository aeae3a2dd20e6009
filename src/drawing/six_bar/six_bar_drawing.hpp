#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// The solution of a six-bar's task as draw_solution() draws it: the best six-bar; the map of its chain, or of a search
/// what it has found; the numbers.
[[nodiscard]] std::string draw_six_bar_solution(const Problem& problem, const SixBarTask& task,
                                                const Solution& solution);

}  // namespace linkwright
