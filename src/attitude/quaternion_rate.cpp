#include "linkwright/attitude/quaternion_rate.hpp"

#include <cmath>

namespace linkwright {
namespace {

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
