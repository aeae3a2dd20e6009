#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright::cli {

/// What was found, in words and tables for people, at most 100 columns wide.
[[nodiscard]] std::string report(const Problem& problem, const Answer& answer);

}  // namespace linkwright::cli
