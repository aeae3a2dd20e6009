#include "support/straight_line_cases.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace linkwright::testing {
namespace {

std::vector<StraightLineFile> read_files() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(LINKWRIGHT_DATA_DIR "/straight_line"))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<StraightLineFile> files;
  for (const auto& path : paths) {
    StraightLineFile file{{}, {}, nlohmann::json::parse(std::ifstream(path))};
    file.name = file.json.at("name");
    for (const auto& solution : file.json.at("solutions")) {
      const auto at = [&](const char* key) { return Point{solution.at(key).at(0), solution.at(key).at(1)}; };
      file.solutions.push_back({file.name,
                                {at("A0"), at("A"), at("B0"), at("B")},
                                at("C"),
                                direction(solution.at("line_direction_rad")),
                                solution.at("contact_points"),
                                solution});
    }
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

const std::vector<StraightLineFile>& straight_line_files() {
  static const std::vector<StraightLineFile> files = read_files();
  return files;
}

const std::vector<StraightLineCase>& straight_line_cases() {
  static const std::vector<StraightLineCase> cases = [] {
    std::vector<StraightLineCase> all;
    for (const StraightLineFile& file : straight_line_files())
      all.insert(all.end(), file.solutions.begin(), file.solutions.end());
    return all;
  }();
  return cases;
}

}  // namespace linkwright::testing
