#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright::testing {

/// data/loads/NAME.json.
[[nodiscard]] nlohmann::json load_file(const std::string& name);

/// The pivots, poses and loads of such a file, lengths in millimetres.
struct LoadedCase {
  FourBar bars;
  std::vector<PrescribedPose> poses;
  Loads loads;
};
[[nodiscard]] LoadedCase loaded_case(const nlohmann::json& file);

/// The block `loads` in the form of problem files.
[[nodiscard]] Loads loads_from(const nlohmann::json& block);
/// One case in that form.
[[nodiscard]] LoadCase load_case_from(const nlohmann::json& block);

[[nodiscard]] inline Point point_from(const nlohmann::json& pair) {
  return {pair.at(0).get<double>(), pair.at(1).get<double>()};
}

}  // namespace linkwright::testing
