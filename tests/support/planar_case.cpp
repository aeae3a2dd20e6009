#include "support/planar_case.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace linkwright::testing {
namespace {

PlanarCase read(const std::filesystem::path& path) {
  PlanarCase result{path.stem().string(), nlohmann::json::parse(std::ifstream(path)), {}};
  for (const auto& position : result.json.at("positions")) {
    PrescribedPose prescribed{{{position[0][0], position[0][1]}, position[0][2]}, {}};
    for (std::size_t m = 1; m < position.size(); ++m)
      prescribed.derivatives.push_back({{position[m][0], position[m][1]}, position[m][2]});
    result.poses.push_back(prescribed);
  }
  return result;
}

}  // namespace

const std::vector<PlanarCase>& planar_cases() {
  static const std::vector<PlanarCase> cases = [] {
    std::vector<PlanarCase> found;
    for (const auto& entry : std::filesystem::directory_iterator(LINKWRIGHT_DATA_DIR "/planar"))
      if (entry.path().extension() == ".json") found.push_back(read(entry.path()));
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return found;
  }();
  return cases;
}

const PlanarCase& planar_case(const std::string& name) {
  for (const PlanarCase& c : planar_cases())
    if (c.name == name) return c;
  throw std::out_of_range("no case " + name);
}

}  // namespace linkwright::testing
