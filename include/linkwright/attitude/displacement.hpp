#pragma once

#include <array>

#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/attitude/rotation.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

/// A 4×4 matrix by rows, over the coordinates (x, y, z, 1) of points and (x, y, z, 0) of directions.
using Matrix4x4 = std::array<std::array<double, 4>, 4>;

/// A displacement of space: a rotation and a translation. Any pair of them is one, so the members are open.
///
/// T_ij = [C_ij d; 0 1] maps coordinates of points in frame j to coordinates in frame i, where d, in i, is the origin
/// of j: (r)_i = d + C_ij (r)_j. As an active displacement the same matrix carries frame i onto frame j, and the point
/// that lies at r to d + C_ij r, both in i. Products chain, T_ik = T_ij T_jk. The displacement of a body from pose T_01
/// to pose T_02, seen in frame 0, is T_02 T_01⁻¹. (Han Jianyou et al., Modern Synthesis Theory and Methods of Linkages,
/// 2013, sections 1.3.1 and 1.3.2.)
struct Displacement {
  Rotation rotation;      ///< C_ij
  Vector3 translation{};  ///< d: origin of frame j in frame i, in the user's unit of length

  /// Pure translation by d.
  [[nodiscard]] static constexpr Displacement translated(Vector3 d) { return {Rotation(), d}; }

  /// A checked 4×4 matrix. Errors: `not_finite`, `last_row` (it is not 0 0 0 1 to `largest_error`), and those of
  /// Rotation::from_matrix() for its upper left 3×3 part, which takes the nearest rotation within `largest_error`.
  [[nodiscard]] static Result<Displacement> from_matrix(const Matrix4x4& t_ij,
                                                        double largest_error = tolerance::orthogonality);

  /// T_ij, its last row 0 0 0 1.
  [[nodiscard]] Matrix4x4 matrix() const;

  /// T_ji: the rotation C_ijᵀ, the translation −C_ijᵀ d.
  [[nodiscard]] constexpr Displacement inverse() const {
    return {rotation.inverse(), -rotation.apply_inverse(translation)};
  }

  /// T_ik of T_ij and T_jk: the displacement T_jk about axes carried along by T_ij.
  [[nodiscard]] friend constexpr Displacement operator*(const Displacement& ij, const Displacement& jk) {
    return {ij.rotation * jk.rotation, ij.apply_to_point(jk.translation)};
  }

  /// (r)_i of the point (r)_j; equally the point that r becomes when it is displaced, both in one frame.
  [[nodiscard]] constexpr Vector3 apply_to_point(Vector3 r_j) const { return translation + rotation.apply(r_j); }
  /// (u)_i of the direction, or any free vector, (u)_j: translations do not move it.
  [[nodiscard]] constexpr Vector3 apply_to_direction(Vector3 u_j) const { return rotation.apply(u_j); }

  /// With the rotation that is nearest to its own: undoes what rounding did in long chains of products.
  [[nodiscard]] Displacement renormalized() const { return {rotation.renormalized(), translation}; }

  friend constexpr bool operator==(const Displacement&, const Displacement&) = default;
};

}  // namespace linkwright
