#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/path_task.hpp"

namespace linkwright::testing {

/// A path task with linkages that an independent implementation computed to 40 digits: data/path.
struct PathCase {
  std::string name;
  nlohmann::json json;
  PathTask task;
};

/// "film_claw_timed", …
[[nodiscard]] PathCase path_case(const std::string& name);

[[nodiscard]] PathTask path_task(const nlohmann::json& json);

/// The bars of one of its linkages.
[[nodiscard]] FourBar bars_of(const nlohmann::json& linkage);

/// From (x, y, degrees of the crank).
[[nodiscard]] PathTask timed_points(const std::vector<std::array<double, 3>>& points);

}  // namespace linkwright::testing
