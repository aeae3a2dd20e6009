#pragma once

#include "linkwright/attitude/euler_angles.hpp"

namespace linkwright {

/// The frame that takes part in precession ψ and nutation ϑ of a body, but not in its spin φ about its own axis z: the
/// frame e^(2) after the first two of the Euler angles 3-1-3, which serves axially symmetric bodies. (Resal's frame:
/// Liu Yanzhu, Mathematical description of the attitude of a rigid body (I), 2021, section 4; Han Jianyou et al.,
/// Modern Synthesis Theory and Methods of Linkages, 2013, equation 1-20, with θ, α for ψ, ϑ.)
struct ResalFrame {
  /// C_im = R_z(ψ) R_x(ϑ): coordinates in Resal's frame m to the fixed frame i.
  Rotation frame;
  /// The turn about the common axis z that is left from Resal's frame to the body's, radians: C_ij = C_im R_z(φ).
  double spin = 0;
};

/// C_im = R_z(ψ) R_x(ϑ), radians.
[[nodiscard]] Rotation resal_frame(double precession, double nutation);

/// Resal's frame of a body whose attitude is C_ij. At ϑ = 0 and π precession and spin cannot be told apart: all of it
/// counts as precession, and the spin is 0 (EulerDecomposition says when).
[[nodiscard]] ResalFrame resal_frame(const Rotation& c_ij);

}  // namespace linkwright
