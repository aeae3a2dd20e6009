#include "linkwright/attitude/rotation_vector.hpp"

#include <cmath>

namespace linkwright {
namespace {

/// Below it three terms of a series in the square are exact to 1e-24.
constexpr double small = 1e-4;

/// sin(θ/2)/θ.
double half_sine_quotient(double theta) {
  if (theta >= small) return std::sin(theta / 2) / theta;
  const double square = theta * theta;
  return 0.5 - square / 48 * (1 - square / 80);
}

/// θ / sin(θ/2), θ in [0, π], of cosine and sine of θ/2.
double inverse_half_sine_quotient(double cosine, double sine) {
  if (sine >= small) return 2 * std::atan2(sine, cosine) / sine;
  const double square = sine * sine;
  return 2 + square / 3 * (1 + square * 9 / 20);
}

}  // namespace

Result<RotationVector> RotationVector::of(Vector3 phi) {
  if (!std::isfinite(norm(phi)))
    return Error{"not_finite", "rotation_vector", "its length is not a number or infinite: give three finite numbers"};
  return RotationVector(phi);
}

RotationVector RotationVector::of(const UnitQuaternion& q_ij) {
  const UnitQuaternion q = q_ij.canonical();
  return RotationVector(inverse_half_sine_quotient(q.w(), norm(q.v())) * q.v());
}

UnitQuaternion RotationVector::quaternion() const {
  const double angle = norm(phi_);
  return *UnitQuaternion::of(std::cos(angle / 2), half_sine_quotient(angle) * phi_);
}

}  // namespace linkwright
