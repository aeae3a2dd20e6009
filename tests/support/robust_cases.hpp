#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright::testing {

/// A file of data/robust: "guidance", "function", "lambda".
[[nodiscard]] nlohmann::json robust_file(const std::string& name);

/// The linkage of parameters `par` at each of the input's directions `phis`, in the assembly of `sign`.
[[nodiscard]] std::vector<TracingFourBar> robust_positions(const nlohmann::json& par, const nlohmann::json& phis,
                                                           double sign);

}  // namespace linkwright::testing
