#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright::testing {

/// A four-bar with a point that runs straight, computed with 30 digits; `json` has the rest of it.
struct StraightLineCase {
  std::string name;
  FourBar four_bar;
  Point point;
  Point direction;
  int contact_points = 0;
  nlohmann::json json;
};

/// All solutions of all files in data/straight_line.
[[nodiscard]] const std::vector<StraightLineCase>& straight_line_cases();

}  // namespace linkwright::testing
