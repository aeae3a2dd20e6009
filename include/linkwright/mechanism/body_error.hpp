#pragma once

#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// How far a body is from where a pose wants it.
struct BodyError {
  double distance = 0;  ///< of the moving frame's origin, user's unit
  double angle = 0;     ///< radians in [0, π]

  friend bool operator==(const BodyError&, const BodyError&) = default;
};
[[nodiscard]] inline BodyError body_error(const Pose& body, const Pose& wanted) {
  return {std::abs(body.origin - wanted.origin), std::abs(wrap_signed(body.angle - wanted.angle))};
}

}  // namespace linkwright
