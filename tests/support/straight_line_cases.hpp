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

/// A task and its solutions, none where there is none.
struct StraightLineFile {
  std::string name;
  std::vector<StraightLineCase> solutions;
  nlohmann::json json;
};

/// All files in data/straight_line.
[[nodiscard]] const std::vector<StraightLineFile>& straight_line_files();
/// All their solutions.
[[nodiscard]] const std::vector<StraightLineCase>& straight_line_cases();

}  // namespace linkwright::testing
