#pragma once

#include <span>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Whether a grounded link keeps its length over the poses; all points in the frame of the poses.
class LengthCheck {
 public:
  explicit LengthCheck(std::span<const PrescribedPose> poses);

  /// Worst change of the distance of a fixed point and a point of the body, as a share of it. `circle` as it lies in
  /// the first pose.
  [[nodiscard]] double residual(Point center, Point circle) const;

 private:
  struct Move {
    Point turn, origin;
  };
  Point first_origin_;
  std::vector<Move> moves_;  ///< to the other poses
};

}  // namespace linkwright
