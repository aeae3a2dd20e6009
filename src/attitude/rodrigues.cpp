#include "linkwright/attitude/rodrigues.hpp"

#include <cmath>

namespace linkwright {
namespace {

Error not_finite(const char* place) {
  return {"not_finite", place, "a component is not a number or infinite: give three finite numbers"};
}

}  // namespace

Result<RodriguesVector> RodriguesVector::of(Vector3 g) {
  if (!is_finite(g)) return not_finite("rodrigues");
  return RodriguesVector(g);
}

std::optional<RodriguesVector> RodriguesVector::of(const UnitQuaternion& q_ij) {
  const Vector3 g = q_ij.v() / q_ij.w();
  if (!is_finite(g)) return std::nullopt;
  return RodriguesVector(g);
}

UnitQuaternion RodriguesVector::quaternion() const { return *UnitQuaternion::of(1, g_); }

Result<ModifiedRodriguesVector> ModifiedRodriguesVector::of(Vector3 m) {
  if (!is_finite(m)) return not_finite("mrp");
  return ModifiedRodriguesVector(m);
}

ModifiedRodriguesVector ModifiedRodriguesVector::of(const UnitQuaternion& q_ij) {
  const UnitQuaternion q = q_ij.canonical();
  return ModifiedRodriguesVector(q.v() / (1 + q.w()));
}

std::optional<ModifiedRodriguesVector> ModifiedRodriguesVector::shadow() const {
  const double length = norm(m_);
  const Vector3 other = -(m_ / length) / length;  // the square may underflow
  if (!is_finite(other)) return std::nullopt;
  return ModifiedRodriguesVector(other);
}

UnitQuaternion ModifiedRodriguesVector::quaternion() const {
  const double length = norm(m_);
  if (length <= 1) return *UnitQuaternion::of((1 - length) * (1 + length), 2.0 * m_);
  const Vector3 inside = m_ / length / length;  // of the shadow, so that the square does not overflow
  const double inverse = 1 / length;
  return *UnitQuaternion::of((inverse - 1) * (inverse + 1), 2.0 * inside);
}

}  // namespace linkwright
