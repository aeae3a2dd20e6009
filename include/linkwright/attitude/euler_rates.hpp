#pragma once

#include <array>

#include "linkwright/attitude/angular_motion.hpp"
#include "linkwright/attitude/euler_angles.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// First and second derivatives of the three angles of a sequence by time, in the order of the angles.
struct EulerRates {
  std::array<double, 3> rates{};          ///< ṫ₁, ṫ₂, ṫ₃
  std::array<double, 3> accelerations{};  ///< ẗ₁, ẗ₂, ẗ₃
};

/// The matrix B of ω_i = B ṫ: its columns are the axes of the three turns, unit vectors in i as they stand in this
/// attitude. Intrinsic abc: e_a, R_a(t₁) e_b, R_a(t₁) R_b(t₂) e_c. Its determinant is ± sin t₂ (proper Euler angles) or
/// ± cos t₂ (Cardan angles): 0 at gimbal lock, where first and third axis lie in one line. Finite angles.
[[nodiscard]] Matrix3x3 rate_matrix(const EulerAngles& angles);

/// ω = B ṫ and ε = B ẗ + Ḃ ṫ, in i (in j: Rotation::apply_inverse() of both). Finite angles and rates.
[[nodiscard]] AngularMotion angular_motion(const EulerAngles& angles, const EulerRates& rates);

/// Rates that make a motion, and how well they are determined.
struct EulerRatesFit {
  EulerRates rates;

  /// `gimbal_lock` where lock_distance is at most tolerance::gimbal_lock. Then no rates make the part of ω at right
  /// angles to the two axes that fell together, and those that there are, are not the only ones: the least of the least
  /// squares are given, which share the turn evenly between first and third.
  Singularity singularity = Singularity::none;
  /// How far the angles are from gimbal lock, as in EulerDecomposition. Rates grow with ω / lock_distance.
  double lock_distance = 0;
  double velocity_residual = 0;      ///< |ω − B ṫ|: what the rates leave out; 0 off the lock
  double acceleration_residual = 0;  ///< |ε − B ẗ − Ḃ ṫ|, the same
};

/// The rates and second derivatives of the angles of ω and ε in i, for each of 24 sequences: to a few 1e-16 of the
/// largest of them, however near the lock. By the triad of the second axis and the two bisectors of first and third
/// axis, in which B is diagonal in the sum and the difference of their rates: no matrix is inverted. Errors:
/// `not_finite`.
[[nodiscard]] Result<EulerRatesFit> euler_rates(const EulerAngles& angles, const AngularMotion& in_i);

}  // namespace linkwright
