#pragma once

#include <array>
#include <string>
#include <string_view>

#include "linkwright/attitude/rotation.hpp"

namespace linkwright {

/// What the turns of a sequence are about: `intrinsic`, axes that the earlier turns have carried along; `extrinsic`,
/// axes at rest.
enum class Turning : unsigned char { intrinsic, extrinsic };

/// Three turns about coordinate axes, one after the other, no two neighbours about the same axis: 12 sequences, each
/// intrinsic or extrinsic. With R_a the matrix of Rotation::about(a, ·),
///
///     intrinsic abc (t₁, t₂, t₃):  C_ij = R_a(t₁) R_b(t₂) R_c(t₃)
///     extrinsic abc (t₁, t₂, t₃):  C_ij = R_c(t₃) R_b(t₂) R_a(t₁), the intrinsic cba (t₃, t₂, t₁)
///
/// Six sequences begin and end with the same axis (aba, proper Euler angles), six have three different ones (abc,
/// Cardan or Tait-Bryan angles).
class EulerSequence {
 public:
  /// By three letters of x, y, z or digits of 1, 2, 3, with or without hyphens: "zxz", "3-1-3". The error,
  /// `unknown_sequence`, lists the twelve.
  [[nodiscard]] static Result<EulerSequence> named(std::string_view name, Turning turning = Turning::intrinsic);

  /// Euler angles 3-1-3, intrinsic zxz: precession ψ, nutation ϑ, spin φ. Singular at ϑ = nπ. (Liu Yanzhu, Mathematical
  /// description of the attitude of a rigid body (I), 2021, section 4, equations 14 to 16.)
  ///
  ///            ⎡ cψ cφ − sψ cϑ sφ   −cψ sφ − sψ cϑ cφ    sψ sϑ ⎤
  ///     C_ij = ⎢ sψ cφ + cψ cϑ sφ   −sψ sφ + cψ cϑ cφ   −cψ sϑ ⎥
  ///            ⎣      sϑ sφ               sϑ cφ            cϑ  ⎦
  [[nodiscard]] static constexpr EulerSequence euler_313() { return {Axis::z, Axis::x, Axis::z}; }

  /// The same under the book's names, (θ, α, δ): about z, the line of nodes, the new z. (Han Jianyou et al., Modern
  /// Synthesis Theory and Methods of Linkages, 2013, section 1.1.3, equation 1-21.)
  [[nodiscard]] static constexpr EulerSequence book_zxz() { return euler_313(); }

  /// The book's (θ, β, α), intrinsic zyx: about z, then the new y, then the new x. Singular at β = π/2 + nπ. (Equation
  /// 1-22; its third row is misprinted: it reads −sβ, cβ sα, cβ cα.)
  ///
  ///            ⎡ cθ cβ   cθ sβ sα − sθ cα   cθ sβ cα + sθ sα ⎤
  ///     C_ij = ⎢ sθ cβ   sθ sβ sα + cθ cα   sθ sβ cα − cθ sα ⎥
  ///            ⎣  −sβ          cβ sα              cβ cα      ⎦
  [[nodiscard]] static constexpr EulerSequence book_zyx() { return {Axis::z, Axis::y, Axis::x}; }

  /// Cardan angles 1-2-3, intrinsic xyz: α, β, γ, the turns of outer ring, inner ring and rotor of a gimbal. All three
  /// are small for a small turn; singular at β = π/2 + nπ. (Liu Yanzhu, 2021, section 5.)
  [[nodiscard]] static constexpr EulerSequence cardan_123() { return {Axis::x, Axis::y, Axis::z}; }

  /// The twelve: xyz, xzy, yxz, yzx, zxy, zyx, then xyx, xzx, yxy, yzy, zxz, zyz.
  [[nodiscard]] static const std::array<EulerSequence, 12>& all(Turning turning = Turning::intrinsic);

  /// In the order in which the turns are made, as are the three angles.
  [[nodiscard]] constexpr Axis first() const { return first_; }
  [[nodiscard]] constexpr Axis second() const { return second_; }
  [[nodiscard]] constexpr Axis third() const { return third_; }
  [[nodiscard]] constexpr Turning turning() const { return turning_; }
  /// The first axis is the third, too (aba).
  [[nodiscard]] constexpr bool is_proper_euler() const { return first_ == third_; }
  /// The sequence of the other kind that makes the same rotation with the three angles in reverse order.
  [[nodiscard]] constexpr EulerSequence reversed() const {
    return {third_, second_, first_, turning_ == Turning::intrinsic ? Turning::extrinsic : Turning::intrinsic};
  }
  /// "zxz".
  [[nodiscard]] std::string name() const;

  friend constexpr bool operator==(const EulerSequence&, const EulerSequence&) = default;

 private:
  constexpr EulerSequence(Axis first, Axis second, Axis third, Turning turning = Turning::intrinsic)
      : first_(first), second_(second), third_(third), turning_(turning) {}

  Axis first_, second_, third_;
  Turning turning_;
};

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
