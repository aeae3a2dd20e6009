#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/mechanism/pose.hpp"

namespace linkwright::testing {

/// A worked four-position task of data/planar with its answers (data/README.md).
struct PlanarCase {
  std::string name;
  nlohmann::json json;
  std::vector<PrescribedPose> poses;

  [[nodiscard]] bool is_finite() const { return poses.size() == 4; }
};

/// All of them, by name.
[[nodiscard]] const std::vector<PlanarCase>& planar_cases();
[[nodiscard]] const PlanarCase& planar_case(const std::string& name);

}  // namespace linkwright::testing
