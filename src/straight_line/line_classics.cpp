#include "straight_line/line_classics.hpp"

#include "straight_line/placed_shape.hpp"

namespace linkwright {

std::vector<LineShape> line_classics(ShapeKind kind) {
  switch (kind) {
    // Frame, crank, coupler and rocker 2 : 1 : 2.5 : 2.5, the point as far beyond the coupler (K. Hoecken); 4 : 5 : 2 :
    // 5, the point in the middle (P. L. Chebyshev): cognates, whose path is 4 from the input's pivot and touches its
    // line above the middle of the frame and, 2 from there, at both ends.
    case ShapeKind::two_tangencies:
      return {shape_of_tangencies(2.0 / 4, 4.0 / 4, 1.0 / 4, 5.0 / 4, 1),
              shape_of_tangencies(2.0 / 4, 4.0 / 4, 5.0 / 4, 1.0 / 4, -1)};
    // Arms as long as twice the coupler (J. Watt, 1784).
    case ShapeKind::parallel_side_links:
      return {shape_of_lengths(kind, 2, -2)};
    // The grasshopper (O. Evans, 1803): crank and point on a line at right angles to the long arm.
    case ShapeKind::ball_point_on_frame:
      return {shape_of_lengths(kind, -0.2, -0.4), shape_of_lengths(kind, -1.0 / 3, 1)};
    // Links and coupler as long as half the frame (R. Roberts), the point at the inflection pole.
    case ShapeKind::isosceles_trapezoid:
      return {shape_of_lengths(kind, 1 / 1.7320508075688772, -1.7320508075688772)};
    default:
      return {};
  }
}

}  // namespace linkwright
