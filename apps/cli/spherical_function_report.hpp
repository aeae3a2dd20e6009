#pragma once

#include <string>

#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/problem.hpp"

namespace linkwright::cli {

/// The counts of the map, the linkages listed with their angles, and how well each generates the function.
[[nodiscard]] std::string spherical_function_report(const Problem& problem, const SphericalFunctionAnswer& answer);

}  // namespace linkwright::cli
