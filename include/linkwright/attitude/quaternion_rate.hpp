#pragma once

#include "linkwright/attitude/angular_motion.hpp"
#include "linkwright/attitude/quaternion.hpp"

namespace linkwright {

/// A derivative of a unit quaternion by time, scalar first. It has the sign of the quaternion that it is of: −q has
/// −q̇.
struct QuaternionRate {
  double w = 0;
  Vector3 v{};
};

/// q̇ = ½ (0, ω_i) q of ω in i. (Shuster, A survey of attitude representations, 1993.) The same as ½ q (0, ω_j).
[[nodiscard]] QuaternionRate quaternion_rate(const UnitQuaternion& q_ij, Vector3 omega_i);

/// q̈ = ½ (0, ε_i) q − ¼ ω² q of the motion in i.
[[nodiscard]] QuaternionRate quaternion_acceleration(const UnitQuaternion& q_ij, const AngularMotion& in_i);

/// What derivatives of a quaternion say of the motion, and what is left over.
struct QuaternionRateFit {
  AngularMotion in_i;
  double velocity_defect = 0;  ///< scalar part of 2 q̇ q⁻¹: twice the rate at which q would leave the unit length
  double acceleration_defect = 0;  ///< scalar part of 2 q̈ q⁻¹, plus ½ ω²; 0 where no second derivative was given
};

/// ω_i, the vector part of 2 q̇ q⁻¹: whatever would change the length of q is left out and told. Errors:
/// `not_finite`.
[[nodiscard]] Result<QuaternionRateFit> angular_velocity(const UnitQuaternion& q_ij, const QuaternionRate& first);

/// ω_i, and ε_i, the vector part of 2 q̈ q⁻¹. Errors: `not_finite`.
[[nodiscard]] Result<QuaternionRateFit> angular_motion(const UnitQuaternion& q_ij, const QuaternionRate& first,
                                                       const QuaternionRate& second);

}  // namespace linkwright
