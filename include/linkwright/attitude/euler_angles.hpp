#pragma once

#include "linkwright/attitude/euler_sequence.hpp"

namespace linkwright {

/// A rotation as three turns; radians, in the order in which the turns are made. Any finite angles: of() checks.
struct EulerAngles {
  EulerSequence sequence;
  double first = 0, second = 0, third = 0;

  /// Errors: `not_finite`, one for each angle, at `angles[0]`, `angles[1]`, `angles[2]`.
  [[nodiscard]] static Result<EulerAngles> of(const EulerSequence& sequence, double first, double second, double third);

  [[nodiscard]] UnitQuaternion quaternion() const;  ///< q_ij
  [[nodiscard]] Rotation rotation() const;          ///< C_ij, by the product of the three matrices
};

/// Whether the three angles are determined.
enum class Singularity : unsigned char {
  none,
  gimbal_lock,  ///< the first axis and the third have come to lie in one line: only first + third or first − third is
};

/// The three angles of a rotation, with what is to be known about how well they are determined.
struct EulerDecomposition {
  /// first, third in (−π, π]; second in [0, π] for proper Euler angles, in [−π/2, π/2] for Cardan angles. They always
  /// make the rotation again, to a few ulps.
  EulerAngles angles;

  /// `gimbal_lock` where lock_distance is at most tolerance::gimbal_lock, what rounding makes of locked attitudes. Then
  /// one angle was chosen: the last turn of an intrinsic sequence, the first of an extrinsic one, is zero; and the
  /// second is its singular value to the last bit.
  Singularity singularity = Singularity::none;

  /// How far the attitude is from gimbal lock, in [0, √½]: the sine of half the angle by which the second turn misses
  /// its next singular value. Nearer, first and third err by a few 1e-16 / lock_distance each, in such a way that the
  /// rotation and `determined` do not.
  double lock_distance = 0;

  /// The combination of the two that is determined whatever the distance, in (−π, π]:
  /// first + determined_sign · third.
  double determined = 0;
  int determined_sign = 1;

  /// lock_distance is below tolerance::near_gimbal_lock: worth a warning.
  [[nodiscard]] bool is_near_gimbal_lock() const;
};

/// The three angles by which the sequence makes the rotation, for all 24 sequences at once: by the sums and differences
/// of half-angles that the quaternion shows, which are exact also where the angles themselves are not determined.
/// (Bernardes and Viollet, Quaternion to Euler angles conversion: a direct, general and computationally efficient
/// method, 2022.) Cardan angles of small turns are relatively exact.
[[nodiscard]] EulerDecomposition euler_angles(const UnitQuaternion& q_ij, const EulerSequence& sequence);
[[nodiscard]] EulerDecomposition euler_angles(const Rotation& c_ij, const EulerSequence& sequence);

}  // namespace linkwright
