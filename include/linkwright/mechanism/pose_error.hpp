#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A pose that a linkage need not pass exactly.
struct RelaxedPose {
  Pose pose;
  std::size_t index = 0;  ///< how many of the poses served come before it
  double size = 1;        ///< length by which an angle is multiplied to be weighed against a distance, > 0
};

/// How near a driven four-bar brings its coupler to a relaxed pose.
struct PoseError {
  double distance = 0;  ///< of the moving frame's origin, user's unit
  double angle = 0;     ///< radians in [0, π]
  double turn = 0;      ///< of the input there, from the first pose served, radians in the sense of travel

  /// √(distance² + (size · angle)²), user's unit; `size` as RelaxedPose::size.
  [[nodiscard]] double combined(double size) const { return std::hypot(distance, size * angle); }
};

/// The coupler's pose of least √(distance² + (size · angle)²), in the order of the task: between the poses served that
/// come before and after, on the way that find_defects judges; before the first and after the last one, as far as the
/// input can turn without a dead point (a crank's rest of the turn). Where those neighbours are not on the branch of
/// the first pose, or not in order, anywhere on that branch. `poses`: those served, the first being the one in which
/// `four_bar` is given. Nothing where there is no linkage.
[[nodiscard]] std::optional<PoseError> pose_error(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                                  const RelaxedPose& relaxed);

}  // namespace linkwright
