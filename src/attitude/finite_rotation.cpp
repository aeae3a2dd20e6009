#include "finite_rotation.hpp"

#include <cmath>

namespace linkwright {

FiniteRotation::FiniteRotation(const AxisAngle& turn)
    : turn_(turn), sine_(std::sin(turn.angle())), cosine_(std::cos(turn.angle())) {
  const double half = std::sin(turn.angle() / 2);
  versine_ = 2 * half * half;
}

Vector3 FiniteRotation::apply(Vector3 a0) const {
  const Vector3 p = turn_.axis();
  return cosine_ * a0 + versine_ * dot(p, a0) * p + sine_ * cross(p, a0);
}

Dyadic FiniteRotation::dyadic() const {
  const Vector3 p = turn_.axis();
  return cosine_ * Dyadic::unit() + versine_ * Dyadic(p, p) + sine_ * Dyadic::cross(p);
}

Matrix3x3 FiniteRotation::matrix() const {
  const Vector3 p = turn_.axis(), s = sine_ * p;
  const double xy = versine_ * p.x * p.y, yz = versine_ * p.y * p.z, zx = versine_ * p.z * p.x;
  return {{{{cosine_ + versine_ * p.x * p.x, xy - s.z, zx + s.y},
            {xy + s.z, cosine_ + versine_ * p.y * p.y, yz - s.x},
            {zx - s.y, yz + s.x, cosine_ + versine_ * p.z * p.z}}}};
}

Matrix3x3 FiniteRotation::matrix_minus_identity() const { return turn_.quaternion().matrix_minus_identity(); }

}  // namespace linkwright
