#pragma once

#include <vector>

#include "linkwright/attitude/given_orientation.hpp"
#include "linkwright/mechanism/positions.hpp"

namespace linkwright {

/// An orientation of a body about a fixed point and, in this order, its angular velocity, angular acceleration and
/// angular jerk there, by any parameter that grows along the task (fixed frame, radians per power of the parameter).
/// With m derivatives it counts as m + 1 infinitesimally close positions.
struct PrescribedOrientation {
  GivenOrientation orientation;  ///< the turn that carries the body from its reference attitude into this one
  std::vector<Vector3> derivatives;

  /// How many infinitesimally close positions it counts as, ≥ 1.
  [[nodiscard]] int multiplicity() const { return 1 + static_cast<int>(derivatives.size()); }

  friend bool operator==(const PrescribedOrientation&, const PrescribedOrientation&) = default;
};

/// The axis that lies along `axis` when the body is at `from`, when the body is at `to` (fixed frame).
[[nodiscard]] inline Vector3 turned(Vector3 axis, const UnitQuaternion& from, const UnitQuaternion& to) {
  return (to * from.inverse()).apply(axis);
}

}  // namespace linkwright
