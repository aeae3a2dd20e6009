#pragma once

#include <string>

#include "linkwright/synthesis/solve.hpp"

namespace linkwright::cli {

/// How well the linkages listed generate the function, a row to each; empty for other tasks.
[[nodiscard]] std::string function_error_words(const Solution& solution);

/// "the output stands right at every pair to 2e-14°".
[[nodiscard]] std::string precision_words(const Solution& solution);

}  // namespace linkwright::cli
