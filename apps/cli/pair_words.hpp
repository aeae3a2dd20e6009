#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::cli {

/// Five positions: the table of side links. Empty for other tasks.
[[nodiscard]] std::string side_link_words(const Solution& solution);

/// Five positions: every pair as a four-bar, and why it fails; five precision points: every linkage. Empty for others.
[[nodiscard]] std::string pair_words(const Problem& problem, const Solution& solution);

/// Five positions with one freed: what the linkages miss it by. Empty for other tasks.
[[nodiscard]] std::string miss_words(const Problem& problem, const Solution& solution);

/// What freeing one of five positions comes to; empty where nothing was tried.
[[nodiscard]] std::string ways_out_words(const Problem& problem, const Solution& solution);

}  // namespace linkwright::cli
