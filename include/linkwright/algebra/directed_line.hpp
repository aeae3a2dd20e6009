#pragma once

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// A line through a point and a sense along it.
struct DirectedLine {
  Point point{};
  Point direction{1, 0};  ///< unit vector

  /// To the left of the direction, unit vector.
  [[nodiscard]] Point left() const { return {-direction.imag(), direction.real()}; }
  /// The point as (way along the line from `point`, distance to its left) in one complex number, and back.
  [[nodiscard]] Point to_line(Point fixed) const { return std::conj(direction) * (fixed - point); }
  [[nodiscard]] Point to_fixed(Point on_line) const { return point + direction * on_line; }

  friend bool operator==(const DirectedLine&, const DirectedLine&) = default;
};

/// A line with the angle of its direction as it was given, radians.
struct LineAtAngle : DirectedLine {
  double angle = 0;

  LineAtAngle() = default;
  LineAtAngle(Point through, double its_angle)
      : DirectedLine{through, linkwright::direction(its_angle)}, angle(its_angle) {}
  friend bool operator==(const LineAtAngle&, const LineAtAngle&) = default;
};

}  // namespace linkwright
