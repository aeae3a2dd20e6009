#include "linkwright/attitude/point_motion.hpp"

namespace linkwright {

Vector3 AccelerationParts::sum() const { return of_origin + tangential + centripetal + coriolis + relative; }

PointMotion motion_about_fixed_point(const AngularMotion& angular, Vector3 r) {
  const Vector3 velocity = cross(angular.velocity, r);
  return {r, velocity, cross(angular.acceleration, r) + cross(angular.velocity, velocity)};
}

PointMotion point_motion(const BodyMotion& body, Vector3 rho_j) { return point_motion(body, PointMotion{rho_j}); }

PointMotion point_motion(const BodyMotion& body, const PointMotion& rho_j) {
  const Vector3 r = body.attitude.apply(rho_j.position);
  return {body.origin.position + r,
          body.origin.velocity + cross(body.angular.velocity, r) + body.attitude.apply(rho_j.velocity),
          acceleration_parts(body, rho_j).sum()};
}

AccelerationParts acceleration_parts(const BodyMotion& body, const PointMotion& rho_j) {
  const Vector3 r = body.attitude.apply(rho_j.position);
  const auto& [omega, epsilon] = body.angular;
  return {.of_origin = body.origin.acceleration,
          .tangential = cross(epsilon, r),
          .centripetal = cross(omega, cross(omega, r)),
          .coriolis = 2.0 * cross(omega, body.attitude.apply(rho_j.velocity)),
          .relative = body.attitude.apply(rho_j.acceleration)};
}

BodyMotion operator*(const BodyMotion& ij, const BodyMotion& jk) {
  return {ij.attitude * jk.attitude, composed(ij.angular, ij.attitude, jk.angular), point_motion(ij, jk.origin)};
}

BodyMotion inverse(const BodyMotion& ij) {
  // The turn of i against j is the opposite vector, written in j; the product with it is to be at rest.
  const auto in_j = [&ij](Vector3 v) { return ij.attitude.apply_inverse(v); };
  const auto& [omega, epsilon] = ij.angular;
  const auto& [r, v, a] = ij.origin;
  const Vector3 relative = v - cross(omega, r);
  BodyMotion ji{ij.attitude.inverse(), {-in_j(omega), -in_j(epsilon)}, {}};
  ji.origin = {-in_j(r), -in_j(relative), -in_j(a - cross(epsilon, r) - cross(omega, v) - cross(omega, relative))};
  return ji;
}

}  // namespace linkwright
