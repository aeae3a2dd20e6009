#include "linkwright/attitude/angular_motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace linkwright {
namespace {

Error not_finite() {
  return {"not_finite", "derivative", "an element is not a number or infinite: give nine finite numbers"};
}

Error not_a_derivative(const char* code, const char* place, const char* what, double defect, double size) {
  return {code,
          place,
          fmt::format("not a derivative of this rotation: {}, off by {:.3g} of {:.3g}; give the matrix and its "
                      "derivatives at the same time, in the same order of frames",
                      what, defect, size),
          {{"defect", defect}, {"size", size}}};
}

Matrix3x3 symmetric_part(const Matrix3x3& a) { return 0.5 * (a + transposed(a)); }

bool is_finite(const QuaternionRate& rate) { return std::isfinite(rate.w) && linkwright::is_finite(rate.v); }

Error not_finite_rate() {
  return {"not_finite", "quaternion_rate", "a component is not a number or infinite: give four finite numbers"};
}

/// ½ (0, u) q.
QuaternionRate half_product(Vector3 u, const UnitQuaternion& q) {
  return {-0.5 * dot(u, q.v()), 0.5 * (q.w() * u + cross(u, q.v()))};
}

/// 2 r q⁻¹: what half_product() makes of a vector, back, and the scalar part that it does not make.
QuaternionRate twice_quotient(const QuaternionRate& r, const UnitQuaternion& q) {
  return {2 * (r.w * q.w() + dot(r.v, q.v())), 2.0 * (q.w() * r.v - r.w * q.v() - cross(r.v, q.v()))};
}

}  // namespace

Matrix3x3 angular_velocity_matrix(Vector3 velocity) { return skew_matrix(velocity); }

Matrix3x3 angular_acceleration_matrix(const AngularMotion& motion) {
  const Matrix3x3 omega = skew_matrix(motion.velocity);
  return skew_matrix(motion.acceleration) + omega * omega;
}

RotationDerivatives rotation_derivatives(const Rotation& c_ij, const AngularMotion& in_i) {
  return {angular_velocity_matrix(in_i.velocity) * c_ij.matrix(), angular_acceleration_matrix(in_i) * c_ij.matrix()};
}

Result<AngularMotionFit> angular_velocity(const Rotation& c_ij, const Matrix3x3& first, double largest_defect) {
  if (!is_finite(first)) return not_finite();
  const Matrix3x3 omega = first * transposed(c_ij.matrix());
  AngularMotionFit fit;
  fit.velocity_defect = frobenius_norm(symmetric_part(omega));
  const double size = frobenius_norm(omega);
  if (!(fit.velocity_defect <= largest_defect * size))
    return not_a_derivative("not_a_derivative", "first", "Ċ Cᵀ has to be skew-symmetric", fit.velocity_defect, size);
  fit.in_i.velocity = axial_vector(omega);
  fit.in_j.velocity = c_ij.apply_inverse(fit.in_i.velocity);
  return fit;
}

Result<AngularMotionFit> angular_motion(const Rotation& c_ij, const RotationDerivatives& derivatives,
                                        double largest_defect) {
  if (!is_finite(derivatives.second)) return not_finite();
  Result<AngularMotionFit> fit = angular_velocity(c_ij, derivatives.first, largest_defect);
  if (!fit) return fit;
  const Matrix3x3 acceleration = derivatives.second * transposed(c_ij.matrix());
  const Matrix3x3 centripetal = angular_acceleration_matrix({fit->in_i.velocity, {}});
  fit->acceleration_defect = frobenius_norm(symmetric_part(acceleration - centripetal));
  const double size = std::max(frobenius_norm(acceleration), frobenius_norm(centripetal));
  if (!(fit->acceleration_defect <= largest_defect * size))
    return not_a_derivative("not_a_second_derivative", "second", "the symmetric part of C̈ Cᵀ has to be [ω]×²",
                            fit->acceleration_defect, size);
  fit->in_i.acceleration = axial_vector(acceleration);
  fit->in_j.acceleration = c_ij.apply_inverse(fit->in_i.acceleration);
  return fit;
}

AngularMotion composed(const AngularMotion& ij, const Rotation& c_ij, const AngularMotion& jk) {
  const Vector3 relative = c_ij.apply(jk.velocity);
  return {ij.velocity + relative, ij.acceleration + c_ij.apply(jk.acceleration) + cross(ij.velocity, relative)};
}

QuaternionRate quaternion_rate(const UnitQuaternion& q_ij, Vector3 omega_i) { return half_product(omega_i, q_ij); }

QuaternionRate quaternion_acceleration(const UnitQuaternion& q_ij, const AngularMotion& in_i) {
  const QuaternionRate tangential = half_product(in_i.acceleration, q_ij);
  const double along = -0.25 * dot(in_i.velocity, in_i.velocity);
  return {tangential.w + along * q_ij.w(), tangential.v + along * q_ij.v()};
}

Result<QuaternionRateFit> angular_velocity(const UnitQuaternion& q_ij, const QuaternionRate& first) {
  if (!is_finite(first)) return not_finite_rate();
  const QuaternionRate omega = twice_quotient(first, q_ij);
  return QuaternionRateFit{.in_i = {omega.v, {}}, .velocity_defect = std::fabs(omega.w)};
}

Result<QuaternionRateFit> angular_motion(const UnitQuaternion& q_ij, const QuaternionRate& first,
                                         const QuaternionRate& second) {
  if (!is_finite(second)) return not_finite_rate();
  Result<QuaternionRateFit> fit = angular_velocity(q_ij, first);
  if (!fit) return fit;
  const QuaternionRate epsilon = twice_quotient(second, q_ij);
  const Vector3 omega = fit->in_i.velocity;
  fit->in_i.acceleration = epsilon.v;
  fit->acceleration_defect = std::fabs(epsilon.w + 0.5 * dot(omega, omega));
  return fit;
}

}  // namespace linkwright
