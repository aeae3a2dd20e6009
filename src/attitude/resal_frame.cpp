#include "linkwright/attitude/resal_frame.hpp"

namespace linkwright {

Rotation resal_frame(double precession, double nutation) {
  return Rotation::about_z(precession) * Rotation::about_x(nutation);
}

ResalFrame resal_frame(const Rotation& c_ij) {
  const EulerAngles euler = euler_angles(c_ij, EulerSequence::euler_313()).angles;
  return {resal_frame(euler.first, euler.second), euler.third};
}

}  // namespace linkwright
