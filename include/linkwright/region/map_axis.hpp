#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"

namespace linkwright {

/// The two grounded links of a linkage, and the axes of a map that they have.
enum class Side { input, output };
/// "input", "output".
[[nodiscard]] constexpr std::string_view name(Side side) { return side == Side::input ? "input" : "output"; }

/// A point of a map: the coordinates of one linkage.
struct MapPoint {
  double input = 0, output = 0;  ///< of the driving link and of the other, where each has an axis of its own
};

/// Part of a map: intervals of both coordinates. A discrete axis has no parts: its interval is ignored.
struct MapWindow {
  std::array<double, 2> input{}, output{};

  [[nodiscard]] const std::array<double, 2>& of(Side side) const { return side == Side::input ? input : output; }
};

/// What the coordinate along an axis of a map stands for.
enum class AxisQuantity {
  curve_coordinate,  ///< place on a Burmester curve
  burmester_point,   ///< one of a few dyads; each fills a branch
  side_direction,    ///< direction of the grounded link in position 1, degrees
  side_length,       ///< length of the grounded link, user's unit
  output_scale,      ///< factor on the output's travel
  pair_output,       ///< output angle of one pair, degrees
  nothing,           ///< one place only
  // Of linkages with a straight line; angles in degrees, lengths in the user's unit.
  link_direction,  ///< direction of the line of a grounded link, in [0, 180)
  link_ray,        ///< of the ray from the pole along a grounded link to the pole tangent, in (−90, 90]
  point_ray,       ///< the same of the ray to the point
  pole_height,     ///< of the pole off the line
  pivot_height,    ///< of a ground pivot off the line
  frame_height,    ///< of the point off the ground link
  pivot_distance,  ///< of a ground pivot from the pole, signed
  output_arm,      ///< length of the output link, signed
  link_length,     ///< length of a grounded link, signed
  crank_length,    ///< of the input link
  point_arm,       ///< distance of the point from the input's moving pivot
  crank_range,     ///< angle that the crank turns over the stroke
  // Of three positions with given pivots, user's unit; a centre is a ground pivot, a circle point a moving one.
  center_x,        ///< of the grounded link that is looked for
  center_y,        ///< the same
  circle_x,        ///< the same, in position 1
  circle_y,        ///< the same, in position 1
  center_on_line,  ///< place on the line of ground pivots, from its point on
  circle_on_line,  ///< the same of moving pivots
  // Of paths, of all arms that reach the points from a given pivot.
  arm_reach,       ///< largest distance of a point over the sum of link and arm, in (0, 1]
  arm_difference,  ///< difference of arm and link over the least distance, in [−1, 1]
  layer,           ///< one of the linkages that stand at a place; each fills a branch
  // Of paths that pass near points.
  fitted_curve,  ///< one of the curves that were found; each fills a branch
  realisation,   ///< one of the three four-bars that trace a curve; each fills a branch
};
/// "curve_coordinate", "side_direction", …
[[nodiscard]] std::string_view name(AxisQuantity quantity);
/// It is told in degrees.
[[nodiscard]] bool is_angle(AxisQuantity quantity);

/// How samples are laid along an axis: equal steps of its coordinate, or equal steps of the sum of the great-circle
/// lengths run by the unit vectors of circle point and centre point.
enum class Spacing { coordinate, arc_length };
/// Key in problem files: "coordinate", "arc_length".
[[nodiscard]] std::string_view name(Spacing spacing);

/// The stretch of an axis of a map that a climb keeps to: a branch of a curve.
struct AxisStretch {
  double from = 0, to = 1;
  bool closed = false;  ///< its end is its beginning

  /// The coordinate on the stretch: wrapped where it is closed, otherwise the nearest one.
  [[nodiscard]] double onto(double coordinate) const;
};

/// An axis of a map: branches by rising coordinate, each of length 1, or 0 where it is a single point.
struct MapAxis {
  AxisQuantity quantity = AxisQuantity::curve_coordinate;
  std::vector<CurveBranch> branches;
  /// Several linkages may stand at a place, in layers: on the branch there is the best of them, and layer k has the
  /// coordinates of [k, k + 1), k ≥ 1. Such an axis has one branch.
  int layers = 0;

  /// End of the range of the coordinate; 0 without branches.
  [[nodiscard]] double coordinate_length() const { return branches.empty() ? 0 : branches.back().to; }
  /// The end of a branch is its beginning.
  [[nodiscard]] bool is_closed() const {
    return quantity == AxisQuantity::curve_coordinate || quantity == AxisQuantity::side_direction;
  }
  /// The coordinate on the axis: wrapped where branches close, of a layer where its place is. Elsewhere beyond its ends
  /// there is nothing.
  [[nodiscard]] double onto(double coordinate) const;
  /// Every place of a branch is the same.
  [[nodiscard]] bool is_discrete() const {
    return quantity == AxisQuantity::burmester_point || quantity == AxisQuantity::nothing ||
           quantity == AxisQuantity::layer || quantity == AxisQuantity::fitted_curve ||
           quantity == AxisQuantity::realisation;
  }
  /// The branch on which a coordinate lies.
  [[nodiscard]] AxisStretch stretch_around(double coordinate) const;
};

}  // namespace linkwright
