#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright::soak {

/// What cannot be of what an answer says about loads; `result`: the same as a file has it.
[[nodiscard]] std::vector<std::string> wrongs_of_loads(const Problem& problem, const Answer& answer,
                                                       const nlohmann::json& result);

}  // namespace linkwright::soak
