#pragma once

#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/attitude/rotation.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

/// Angular velocity and angular acceleration of frame j against frame i, both by coordinates in one frame (the
/// functions say which), in radians per unit of time and of time squared.
struct AngularMotion {
  Vector3 velocity{};      ///< ω
  Vector3 acceleration{};  ///< ε = dω/dt, the same vector whether ω is differentiated in i or in j
};

/// First and second derivative of a matrix of direction cosines by time.
struct RotationDerivatives {
  Matrix3x3 first;   ///< Ċ_ij
  Matrix3x3 second;  ///< C̈_ij
};

/// What the derivatives of a matrix say: the motion in both frames, and how far they are from being derivatives of a
/// rotation.
struct AngularMotionFit {
  AngularMotion in_i, in_j;
  double velocity_defect = 0;      ///< Frobenius norm of the symmetric part of Ċ Cᵀ, which should not be there
  double acceleration_defect = 0;  ///< the same of C̈ Cᵀ − [ω]×²; 0 where no second derivative was given
};

/// The angular velocity matrix Ċ Cᵀ = [ω]× (ω in i), or Cᵀ Ċ (ω in j). (Han Jianyou et al., Modern Synthesis Theory and
/// Methods of Linkages, 2013, section 1.2.1.) It carries points of the body to their velocities.
[[nodiscard]] Matrix3x3 angular_velocity_matrix(Vector3 velocity);

/// The angular acceleration matrix C̈ Cᵀ = [ε]× + [ω]×² (both in i), or Cᵀ C̈ (both in j). (Section 1.2.2.) It carries
/// points of the body to their accelerations.
[[nodiscard]] Matrix3x3 angular_acceleration_matrix(const AngularMotion& motion);

/// Ċ = [ω]× C and C̈ = ([ε]× + [ω]×²) C of the motion in i.
[[nodiscard]] RotationDerivatives rotation_derivatives(const Rotation& c_ij, const AngularMotion& in_i);

/// ω of C and Ċ: the skew-symmetric part of Ċ Cᵀ, the nearest one to it. `largest_defect` is the share of the symmetric
/// part in Ċ Cᵀ, in [0, 1], above which Ċ is refused; 1 accepts whatever is finite. Errors: `not_finite`,
/// `not_a_derivative` (with the figure).
[[nodiscard]] Result<AngularMotionFit> angular_velocity(const Rotation& c_ij, const Matrix3x3& first,
                                                        double largest_defect = tolerance::derivative_defect);

/// ω and ε of C, Ċ and C̈: ε is the skew-symmetric part of C̈ Cᵀ; the symmetric part has to be [ω]×². The share is that
/// of the greater of C̈ Cᵀ and [ω]×². Errors as above.
[[nodiscard]] Result<AngularMotionFit> angular_motion(const Rotation& c_ij, const RotationDerivatives& derivatives,
                                                      double largest_defect = tolerance::derivative_defect);

/// The motion of frame k against i of those of j against i (in i) and of k against j (in j): ω_ik = ω_ij + C_ij ω_jk,
/// ε_ik = ε_ij + C_ij ε_jk + ω_ij × C_ij ω_jk, all in i.
[[nodiscard]] AngularMotion composed(const AngularMotion& ij, const Rotation& c_ij, const AngularMotion& jk);

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
