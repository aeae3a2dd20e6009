#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <string>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {

/// Something prescribed with derivatives, which counts as several infinitesimally close positions.
template <class Position>
concept HasMultiplicity = requires(const Position& position) {
  { position.multiplicity() } -> std::same_as<int>;
};

template <class Positions>
concept PositionList = std::ranges::input_range<Positions> && HasMultiplicity<std::ranges::range_value_t<Positions>>;

/// The multiplicities in the field's notation: P-P-P-P, PP-P-P, PPPP, …
template <PositionList Positions>
[[nodiscard]] std::string pattern(const Positions& positions) {
  std::string text;
  for (const auto& position : positions) {
    if (!text.empty()) text += '-';
    text.append(static_cast<std::size_t>(position.multiplicity()), 'P');
  }
  return text;
}

/// Number of positions, each with its multiplicity.
template <PositionList Positions>
[[nodiscard]] int position_count(const Positions& positions) {
  int count = 0;
  for (const auto& position : positions) count += position.multiplicity();
  return count;
}

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
