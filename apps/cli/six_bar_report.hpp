#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright::cli {

/// What was searched and what was found for a six-bar's task, in words and tables, at most 100 columns wide; title and
/// unit of `problem` are printable.
[[nodiscard]] std::string six_bar_report(const Problem& problem, const SixBarAnswer& answer);

/// The analysis of one six-bar in words for people.
[[nodiscard]] std::string six_bar_words(const StoredSixBarAnalysis& analysis);

}  // namespace linkwright::cli
