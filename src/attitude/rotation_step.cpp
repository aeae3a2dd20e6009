#include "rotation_step.hpp"

#include "linkwright/attitude/rotation_vector.hpp"

namespace linkwright {
namespace {

Result<UnitQuaternion> turned(const UnitQuaternion& q_ij, Vector3 rotation_vector_i) {
  const Result<RotationVector> turn = RotationVector::of(rotation_vector_i);
  if (!turn)
    return Error{"not_finite", "omega",
                 "ω times the step is not a number or infinite: give finite ω and a finite step"};
  return turn->quaternion() * q_ij;
}

}  // namespace

Result<UnitQuaternion> rotation_step(const UnitQuaternion& q_ij, Vector3 omega_i, double dt) {
  return turned(q_ij, dt * omega_i);
}

Result<Rotation> rotation_step(const Rotation& c_ij, Vector3 omega_i, double dt) {
  const Result<UnitQuaternion> q = rotation_step(c_ij.quaternion(), omega_i, dt);
  if (!q) return q.errors();
  return Rotation(*q);
}

Result<UnitQuaternion> gauss_step(const UnitQuaternion& q_ij, const std::array<Vector3, 2>& omega_i, double dt) {
  constexpr double root_3_over_12 = 0.14433756729740644113;
  const Vector3 mean = (0.5 * dt) * (omega_i[0] + omega_i[1]);
  return turned(q_ij, mean + (root_3_over_12 * dt * dt) * cross(omega_i[1], omega_i[0]));
}

}  // namespace linkwright
