#include "straight_line/line_atlas.hpp"

#include <string_view>

#include "straight_line/placed_shape.hpp"

namespace linkwright {
namespace {

struct Row {
  std::string_view case_name;
  int layer = 0;
  unsigned turns = 0;
  std::array<float, 4> numbers{};
};

constexpr Row rows[] = {
#include "line_atlas.inc"  // by cmake/line_atlas.cmake
};

}  // namespace

std::vector<AtlasLinkage> line_atlas(ShapeKind kind) {
  const std::string_view case_name = name(placed(LineShape{kind, {}, 0}).task.given);
  std::vector<AtlasLinkage> linkages;
  for (const Row& row : rows) {
    if (row.case_name != case_name) continue;
    AtlasLinkage linkage{{kind, {}, row.turns}, row.layer};
    for (std::size_t k = 0; k < row.numbers.size(); ++k) linkage.shape.numbers[k] = static_cast<double>(row.numbers[k]);
    linkages.push_back(linkage);
  }
  return linkages;
}

}  // namespace linkwright
