#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/planar/path_task.hpp"

namespace linkwright::soak {

/// What is wrong with a linkage listed for a path: turned by its own account, by its crank and its coupler, its point
/// is where the task wants it, its output link keeps its length, and angles and pivots given are kept.
[[nodiscard]] std::vector<std::string> wrongs_of_path(const PathTask& task, const nlohmann::json& wanted,
                                                      const nlohmann::json& entry);

}  // namespace linkwright::soak
