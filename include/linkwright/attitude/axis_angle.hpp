#pragma once

#include "linkwright/attitude/rotation.hpp"

namespace linkwright {

/// A rotation as one turn by an angle about an axis (Euler's theorem: every rotation is one).
class AxisAngle {
 public:
  /// The identity, its axis undefined.
  AxisAngle() = default;

  /// The turn by `angle`, radians of any size and sign, about `axis`, of any length but zero; right-handed. The angle
  /// is kept as given. Errors: `not_finite`, `zero_axis`.
  [[nodiscard]] static Result<AxisAngle> of(Vector3 axis, double angle);

  /// The angle in [0, π] and the axis, both exact to a few ulps of 1 for every rotation, small turns and half-turns
  /// included: θ = 2 atan2(|v|, w), p = v/|v|. At a half-turn p and −p are both right; the one whose first coordinate
  /// that is not zero is positive is taken. The identity has no axis: (0, 0, 1) and axis_defined() false.
  /// This is the inverse that Liu Yanzhu's equation 13 asks for, Mathematical description of the attitude of a rigid
  /// body (I), 2021, without its divisions by 1 − cos θ and its open signs.
  [[nodiscard]] static AxisAngle of(const UnitQuaternion& q_ij);
  /// By the quaternion, which is exact for every angle: the trace is not (cosine_by_trace()).
  [[nodiscard]] static AxisAngle of(const Rotation& c_ij) { return of(c_ij.quaternion()); }

  /// Unit vector: the same coordinates in frames i and j.
  [[nodiscard]] Vector3 axis() const { return axis_; }
  /// Radians.
  [[nodiscard]] double angle() const { return angle_; }
  /// False when the axis is but a convention: it was asked of the identity.
  [[nodiscard]] bool axis_defined() const { return axis_defined_; }

  /// The turn back: the same axis, the opposite angle.
  [[nodiscard]] AxisAngle inverse() const;

  /// q_ij = (cos θ/2, p sin θ/2).
  [[nodiscard]] UnitQuaternion quaternion() const;
  /// C_ij by the finite rotation matrix.
  [[nodiscard]] Rotation rotation() const { return Rotation(quaternion()); }

 private:
  Vector3 axis_{0, 0, 1};
  double angle_ = 0;
  bool axis_defined_ = false;
};

}  // namespace linkwright
