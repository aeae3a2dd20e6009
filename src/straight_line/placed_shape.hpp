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

/// Of lengths in the unit of its kind, which has two.
[[nodiscard]] LineShape shape_of_lengths(ShapeKind kind, double first, double second);
/// Of a λ that touches the line at two places, counted from the foot of its input pivot, in the distance of that; the
/// crank's pin to the left of the way from the pivot to the point (`side` 1), or right (−1), the line to the left.
[[nodiscard]] LineShape shape_of_tangencies(double first, double last, double crank, double arm, int side);

/// All lengths times `scale`, and the line where `line` has it, its point moved by `shift` along ± x and across.
[[nodiscard]] PlacedShape moved(const PlacedShape& shape, double scale, const DirectedLine& line, Point shift);

/// The linkages there, one to each layer.
[[nodiscard]] LineDesigns designs_of_shape(const PlacedShape& shape);

}  // namespace linkwright
