#pragma once

#include <optional>

#include "linkwright/attitude/rotation.hpp"

namespace linkwright {

/// The Rodrigues (Gibbs) vector g = p tan θ/2 = v/w. Runs to infinity at half-turns, where there is none.
/// (Shuster, A survey of attitude representations, 1993.)
class RodriguesVector {
 public:
  /// The identity.
  RodriguesVector() = default;
  /// Errors: `not_finite`.
  [[nodiscard]] static Result<RodriguesVector> of(Vector3 g);

  /// Nothing for a half-turn (w = 0, or so near to it that g overflows).
  [[nodiscard]] static std::optional<RodriguesVector> of(const UnitQuaternion& q_ij);
  /// The same by the canonical quaternion.
  [[nodiscard]] static std::optional<RodriguesVector> of(const Rotation& c_ij) { return of(c_ij.quaternion()); }

  [[nodiscard]] Vector3 vector() const { return g_; }
  /// −g.
  [[nodiscard]] RodriguesVector inverse() const { return RodriguesVector(-g_); }
  /// (1, g)/√(1 + g²), w > 0.
  [[nodiscard]] UnitQuaternion quaternion() const;
  [[nodiscard]] Rotation rotation() const { return Rotation(quaternion()); }

 private:
  explicit RodriguesVector(Vector3 g) : g_(g) {}
  Vector3 g_{};
};

/// The modified Rodrigues vector m = p tan θ/4 = v/(1 + w). Of the two that are the same rotation the one within the
/// unit sphere belongs to the turn by at most π, the other, its shadow −m/|m|², to the turn on the other way round.
/// (Shuster, A survey of attitude representations, 1993; Schaub and Junkins, Stereographic orientation parameters,
/// 1996.)
class ModifiedRodriguesVector {
 public:
  /// The identity.
  ModifiedRodriguesVector() = default;
  /// Any finite vector, within the unit sphere or not: it is kept as given. Errors: `not_finite`.
  [[nodiscard]] static Result<ModifiedRodriguesVector> of(Vector3 m);

  /// |m| ≤ 1, as of the canonical quaternion.
  [[nodiscard]] static ModifiedRodriguesVector of(const UnitQuaternion& q_ij);
  /// The same by the canonical quaternion.
  [[nodiscard]] static ModifiedRodriguesVector of(const Rotation& c_ij) { return of(c_ij.quaternion()); }

  [[nodiscard]] Vector3 vector() const { return m_; }
  /// The other vector of the same rotation, −m/|m|². Nothing for the identity (or so near to it that it overflows): its
  /// shadow is at infinity.
  [[nodiscard]] std::optional<ModifiedRodriguesVector> shadow() const;
  /// −m: of the same length, so within the unit sphere or outside as this one.
  [[nodiscard]] ModifiedRodriguesVector inverse() const { return ModifiedRodriguesVector(-m_); }
  /// (1 − m², 2m)/(1 + m²); w < 0 outside the unit sphere.
  [[nodiscard]] UnitQuaternion quaternion() const;
  [[nodiscard]] Rotation rotation() const { return Rotation(quaternion()); }

 private:
  explicit ModifiedRodriguesVector(Vector3 m) : m_(m) {}
  Vector3 m_{};
};

}  // namespace linkwright
