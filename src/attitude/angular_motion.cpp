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

}  // namespace linkwright
