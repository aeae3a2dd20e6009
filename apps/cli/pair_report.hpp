#pragma once

#include <string>
#include <string_view>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright::cli {

/// Five positions: the table of grounded links. Empty for other tasks.
[[nodiscard]] std::string dyad_words(const FourBarAnswer& answer);

/// Five positions: every pair as a four-bar, and why it fails; five precision points: every linkage. Empty for others.
[[nodiscard]] std::string pair_words(const FourBarAnswer& answer, std::string_view heading);

/// Five positions with one freed: what the linkages miss it by. Empty for other tasks.
[[nodiscard]] std::string pose_error_words(const Problem& problem, const FourBarAnswer& answer);

/// What freeing one of five positions comes to; empty where nothing was tried.
[[nodiscard]] std::string ways_out_words(const Problem& problem, const MotionAnswer& answer);

}  // namespace linkwright::cli
