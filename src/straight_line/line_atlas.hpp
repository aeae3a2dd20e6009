#pragma once

#include <vector>

#include "linkwright/straight_line/line_shape.hpp"

namespace linkwright {

/// A linkage of the atlas: one of those of its shape.
struct AtlasLinkage {
  LineShape shape;
  int layer = 0;
};

/// The best that long searches have found (data/atlas/straight_lines.csv), with which others begin.
[[nodiscard]] std::vector<AtlasLinkage> line_atlas(ShapeKind kind);

}  // namespace linkwright
