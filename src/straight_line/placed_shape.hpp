#pragma once

#include <array>

#include "linkwright/straight_line/line_shape.hpp"
#include "straight_line/line_cases.hpp"

namespace linkwright {

/// A task, its line through the origin along ± x, and a place of its map.
struct PlacedShape {
  StraightLineTask task;
  std::array<double, 2> at{};  ///< radians, or lengths
};
[[nodiscard]] PlacedShape placed(const LineShape& shape);

/// All lengths times `scale`, and the line where `line` has it, its point moved by `shift` along ± x and across.
[[nodiscard]] PlacedShape moved(const PlacedShape& shape, double scale, const DirectedLine& line, Point shift);

/// The linkages there, one to each layer.
[[nodiscard]] LineDesigns designs_of_shape(const PlacedShape& shape);

}  // namespace linkwright
