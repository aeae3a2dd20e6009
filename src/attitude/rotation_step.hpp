#pragma once

#include <array>

#include "linkwright/attitude/rotation.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

// Steps of q̇ = ½ (0, ω) q along the group: each multiplies by the exponential of a rotation vector, so the attitude
// stays a rotation however many steps are taken. Multiplied by the quaternion, whose length is restored in every
// product: matrices would drift. ω is the angular velocity of frame j against i, in i; dt is any time, negative too.
// Errors: `not_finite`, also where ω dt overflows.

/// The attitude after the time dt with constant ω, exp([ω dt]×) C_ij: exact then. With ω(t) at the middle of the step,
/// an error of order dt³ per step, which makes order 2 over a given time (the Lie midpoint rule).
[[nodiscard]] Result<UnitQuaternion> rotation_step(const UnitQuaternion& q_ij, Vector3 omega_i, double dt);

/// The same for a matrix; it goes through the quaternion, so it too stays a rotation.
[[nodiscard]] Result<Rotation> rotation_step(const Rotation& c_ij, Vector3 omega_i, double dt);

/// The shares of a step at which gauss_step() needs ω: ½ ∓ √3/6.
inline constexpr std::array<double, 2> gauss_shares{0.21132486540518711775, 0.78867513459481288225};

/// The attitude after the time dt, of ω in i at the two gauss_shares of the step: by the rotation vector
/// ½ dt (ω₁ + ω₂) + (√3/12) dt² ω₂ × ω₁, an error of order dt⁵ per step, which makes order 4. (Magnus, On the
/// exponential solution of differential equations for a linear operator, 1954; Iserles, Munthe-Kaas, Nørsett and Zanna,
/// Lie-group methods, 2000.)
[[nodiscard]] Result<UnitQuaternion> gauss_step(const UnitQuaternion& q_ij, const std::array<Vector3, 2>& omega_i,
                                                double dt);

}  // namespace linkwright
