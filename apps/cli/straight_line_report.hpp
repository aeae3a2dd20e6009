#pragma once

#include <string>

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright::cli {

/// What report() says of a straight line below its heading.
[[nodiscard]] std::string straight_line_report(const Problem& problem, const StraightLineAnswer& answer);

}  // namespace linkwright::cli
