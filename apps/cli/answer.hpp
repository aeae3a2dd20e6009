#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::cli {

/// What was found, in words and tables for people, at most 100 columns wide.
[[nodiscard]] std::string answer(const Problem& problem, const Solution& solution);

}  // namespace linkwright::cli
