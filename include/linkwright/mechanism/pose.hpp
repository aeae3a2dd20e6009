#pragma once

#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/positions.hpp"

namespace linkwright {

/// Pose of the moving frame in the fixed frame: origin in the user's length unit, angle in radians, counter-clockwise.
struct Pose {
  Point origin{};
  double angle = 0;

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// One derivative of a pose with respect to any parameter that increases along the task
/// (user's length, radians, per power of the parameter).
struct PoseDerivative {
  Point origin{};
  double angle = 0;

  friend bool operator==(const PoseDerivative&, const PoseDerivative&) = default;
};

/// A pose and its first, second, … derivatives. With m derivatives it counts as m + 1 infinitesimally close positions.
struct PrescribedPose {
  Pose pose;
  std::vector<PoseDerivative> derivatives;

  /// How many infinitesimally close positions it counts as, ≥ 1.
  [[nodiscard]] int multiplicity() const { return 1 + static_cast<int>(derivatives.size()); }

  friend bool operator==(const PrescribedPose&, const PrescribedPose&) = default;
};

/// Where the moving point that lies at `point` when the body is at `from` lies when the body is at `to` (fixed frame).
[[nodiscard]] inline Point displaced(Point point, const Pose& from, const Pose& to) {
  return to.origin + direction(to.angle - from.angle) * (point - from.origin);
}

}  // namespace linkwright
