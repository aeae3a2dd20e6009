#include "support/straight_line_cases.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace linkwright::testing {
namespace {

std::vector<StraightLineCase> read_cases() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(LINKWRIGHT_DATA_DIR "/straight_line"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<StraightLineCase> cases;
  for (const auto& file : files) {
    const auto json = nlohmann::json::parse(std::ifstream(file));
    for (const auto& solution : json.at("solutions")) {
      const auto at = [&](const char* key) { return Point{solution.at(key).at(0), solution.at(key).at(1)}; };
      cases.push_back({json.at("name"),
                       {at("A0"), at("A"), at("B0"), at("B")},
                       at("C"),
                       direction(solution.at("line_direction_rad")),
                       solution.at("contact_points"),
                       solution});
    }
  }
  return cases;
}

}  // namespace

const std::vector<StraightLineCase>& straight_line_cases() {
  static const std::vector<StraightLineCase> cases = read_cases();
  return cases;
}

}  // namespace linkwright::testing
