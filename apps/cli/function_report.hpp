#pragma once

#include <string>

#include "linkwright/synthesis/answer.hpp"

namespace linkwright::cli {

/// How well the linkages listed generate the function, a row to each; empty for other tasks.
[[nodiscard]] std::string function_error_words(const FourBarAnswer& answer);

/// "the output stands right at every pair to 2e-14°".
[[nodiscard]] std::string precision_words(const FourBarAnswer& answer);

}  // namespace linkwright::cli
