#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/vector3.hpp"

namespace linkwright {

/// Bodies on hinges that have one degree of freedom together: body 0 is at rest, and body 1, which has a hinge on it,
/// drives. Hinges of the plane z = 0 run along z; about a centre, which is the origin, they are its axes.
struct HingedBodies {
  int bodies = 0;
  std::vector<std::array<int, 2>> hinges;  ///< the two bodies of each
  bool spherical = false;
};

/// How a body moves while the driver turns counter-clockwise (about a centre right-handed about its hinge on body 0) by
/// one radian per unit of time, at a constant rate. Fixed frame.
struct HingedBodyRates {
  Vector3 turning;          ///< angular velocity
  Vector3 turning_up;       ///< angular acceleration
  Vector3 drift, drift_up;  ///< velocity and acceleration of what of the body is at the origin, but for the centripetal

  [[nodiscard]] Vector3 velocity(Vector3 point) const { return drift + cross(turning, point); }
  [[nodiscard]] Vector3 acceleration(Vector3 point) const {
    return drift_up + cross(turning_up, point) + cross(turning, velocity(point));
  }
};

/// By body, with each hinge where `at` has it (about a centre unit vectors). Both bodies of a hinge have its velocity
/// and its acceleration, which is as many linear equations as there are unknowns (Uicker, Pennock, Shigley: Theory of
/// Machines and Mechanisms, 2003, chapters 3 and 4). Nothing at a dead point, where they are unbounded.
[[nodiscard]] std::optional<std::vector<HingedBodyRates>> body_rates(const HingedBodies& linkage,
                                                                     std::span<const Vector3> at);

}  // namespace linkwright
