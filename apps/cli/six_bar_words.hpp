#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::cli {

/// What was searched and what was found for a six-bar's task, in words and tables, at most 100 columns wide; title and
/// unit of `problem` are printable.
[[nodiscard]] std::string six_bar_answer(const Problem& problem, const Solution& solution);

/// The analysis of one six-bar in words for people.
[[nodiscard]] std::string six_bar_words(const SixBarAnalysis& analysis);

}  // namespace linkwright::cli
