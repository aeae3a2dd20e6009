#pragma once

#include "linkwright/attitude/rotation.hpp"

namespace linkwright {

/// The rotation vector φ = θ p, radians: the turn by |φ| about φ. C_ij = exp [φ]×, and φ is its logarithm.
/// Small ones add up to the second order: A ≈ E + [φ]× + ½ [φ]×². (Shuster, A survey of attitude representations,
/// 1993.)
class RotationVector {
 public:
  /// The identity.
  RotationVector() = default;
  /// Any vector of finite length; it is kept as given, turns over π and over whole revolutions included. Errors:
  /// `not_finite`.
  [[nodiscard]] static Result<RotationVector> of(Vector3 phi);

  /// The logarithm, |φ| ≤ π; relatively exact for small turns. At half-turns the sign as in AxisAngle.
  [[nodiscard]] static RotationVector of(const UnitQuaternion& q_ij);
  /// The same by the canonical quaternion.
  [[nodiscard]] static RotationVector of(const Rotation& c_ij) { return of(c_ij.quaternion()); }

  [[nodiscard]] Vector3 vector() const { return phi_; }
  /// −φ, whole revolutions included.
  [[nodiscard]] RotationVector inverse() const { return RotationVector(-phi_); }
  /// The exponential.
  [[nodiscard]] UnitQuaternion quaternion() const;
  [[nodiscard]] Rotation rotation() const { return Rotation(quaternion()); }

 private:
  explicit RotationVector(Vector3 phi) : phi_(phi) {}
  Vector3 phi_{};
};

}  // namespace linkwright
