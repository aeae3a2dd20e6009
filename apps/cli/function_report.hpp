#pragma once

#include <string>

#include "linkwright/synthesis/answer.hpp"

namespace linkwright::cli {

/// How well the linkages listed generate the function, a row to each; empty for other tasks.
[[nodiscard]] std::string function_error_words(const FourBarAnswer& answer);
[[nodiscard]] std::string function_error_words(const SphericalAnswer& answer);

/// "the output stands right at every pair to 2e-14°".
[[nodiscard]] std::string precision_words(const FourBarAnswer& answer);
[[nodiscard]] std::string precision_words(const SphericalAnswer& answer);

/// Where the linkages of a function lie that are counted.
[[nodiscard]] std::string function_map_words(const LinkageFamily& family, const RegionMap& map);
/// What a task of a function leaves open.
[[nodiscard]] std::string function_free_words(const LinkageFamily* family, const WantedFunction& wanted);

}  // namespace linkwright::cli
