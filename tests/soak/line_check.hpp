#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace linkwright::soak {

/// What is wrong with a linkage of a straight line by its own numbers and those required, both as files have them.
[[nodiscard]] std::vector<std::string> wrongs_of_line(const nlohmann::json& wanted, const nlohmann::json& options,
                                                      const nlohmann::json& entry);

}  // namespace linkwright::soak
