#pragma once

#include <array>

#include "linkwright/algebra/matrix3x3.hpp"
#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

/// A coordinate axis of a frame.
enum class Axis : unsigned char { x, y, z };

/// The unit vector of a coordinate axis, in its own frame.
[[nodiscard]] constexpr Vector3 unit_vector(Axis axis) {
  return {axis == Axis::x ? 1.0 : 0.0, axis == Axis::y ? 1.0 : 0.0, axis == Axis::z ? 1.0 : 0.0};
}

/// Three unit vectors along the axes x, y, z of a right-handed frame, all by coordinates in one other frame.
using Triad = std::array<Vector3, 3>;

/// A rotation of space, by its matrix of direction cosines.
///
/// C_ij maps coordinates in the new frame j to coordinates in the old frame i: (r)_i = C_ij (r)_j. Its columns are the
/// axes of j written in i. As an active turn the same matrix carries frame i onto frame j. So products chain,
/// C_ik = C_ij C_jk, and C_ji = C_ijᵀ is the inverse. (Han Jianyou et al., Modern Synthesis Theory and Methods of
/// Linkages, 2013, section 1.1, equations 1-5 to 1-12.) The direction cosine matrix A^(01) of Liu Yanzhu, Mathematical
/// description of the attitude of a rigid body (I): the finite rotation tensor, 2021, is the same object: coordinates
/// in e^(1) to coordinates in e^(0), C_ij with i = 0, j = 1.
///
/// A value is always a rotation, to a few ulps; each product may add another: see renormalized().
class Rotation {
 public:
  /// The identity.
  constexpr Rotation() = default;

  /// C_ij = E + 2w [v]× + 2 [v]×².
  explicit Rotation(const UnitQuaternion& q_ij) : c_ij_(q_ij.matrix()) {}

  /// A checked matrix C_ij. Off a rotation by more than `largest_error` (orthogonality_error()) it is refused; by less,
  /// the nearest rotation is taken. Errors, of which all but the first offer the nearest rotation in their message:
  /// `not_finite`, `not_orthogonal` (with the figure), `reflection` (orthogonal, but the determinant is −1).
  [[nodiscard]] static Result<Rotation> from_matrix(const Matrix3x3& c_ij,
                                                    double largest_error = tolerance::orthogonality);

  /// C_ij of two triads, the axes of frame i and those of frame j, both by coordinates in one third frame: each element
  /// is the cosine of the angle between an axis of i and one of j (the book's table 1.1). Errors as from_matrix().
  [[nodiscard]] static Result<Rotation> from_triads(const Triad& axes_of_i, const Triad& axes_of_j);

  /// C_ij where frame j is frame i turned about one of its axes by `angle`, radians (finite), right-handed
  /// (the book's equations 1-14 about z, 1-15 about x, 1-16 about y).
  [[nodiscard]] static Rotation about(Axis axis, double angle);
  [[nodiscard]] static Rotation about_x(double angle) { return about(Axis::x, angle); }
  [[nodiscard]] static Rotation about_y(double angle) { return about(Axis::y, angle); }
  [[nodiscard]] static Rotation about_z(double angle) { return about(Axis::z, angle); }

  /// C_ij where frame j is frame i turned about `axis` (any length but zero; its coordinates are the same in i and j,
  /// so the cosines of its direction angles will do) by `angle`, radians, right-handed: the book's figure 1.7, the
  /// article's equation 11; FiniteRotation has the tensor. Errors as AxisAngle::of(): `not_finite`, `zero_axis`.
  [[nodiscard]] static Result<Rotation> about_axis(Vector3 axis, double angle);

  /// C_ij.
  [[nodiscard]] constexpr const Matrix3x3& matrix() const { return c_ij_; }
  /// q_ij, canonical.
  [[nodiscard]] UnitQuaternion quaternion() const { return UnitQuaternion::of_matrix(c_ij_); }

  /// C_ji = C_ijᵀ.
  [[nodiscard]] constexpr Rotation inverse() const { return Rotation(transposed(c_ij_)); }

  /// C_ik of C_ij and C_jk: the turn C_jk about axes carried along by the turn C_ij.
  [[nodiscard]] friend constexpr Rotation operator*(const Rotation& ij, const Rotation& jk) {
    return Rotation(ij.c_ij_ * jk.c_ij_);
  }

  /// (r)_i of (r)_j; equally the vector that r becomes when it is turned, both in one frame.
  [[nodiscard]] constexpr Vector3 apply(Vector3 r_j) const { return c_ij_ * r_j; }
  /// (r)_j of (r)_i.
  [[nodiscard]] constexpr Vector3 apply_inverse(Vector3 r_i) const { return r_i * c_ij_; }

  /// The nearest rotation to the matrix as it stands: undoes what rounding did in long chains of products.
  [[nodiscard]] Rotation renormalized() const;

  friend constexpr bool operator==(const Rotation&, const Rotation&) = default;

 private:
  constexpr explicit Rotation(const Matrix3x3& c_ij) : c_ij_(c_ij) {}

  Matrix3x3 c_ij_ = Matrix3x3::identity();
};

/// The angle of the turn between two attitudes, in [0, π].
[[nodiscard]] double angle_between(const Rotation& a, const Rotation& b);

// The properties of a matrix of direction cosines, as measures of how far any 3×3 matrix is from having them. (Han
// Jianyou et al., Modern Synthesis Theory and Methods of Linkages, 2013, section 1.1.2; Liu Yanzhu, Mathematical
// description of the attitude of a rigid body (I), 2021, appendix 1.) A rotation has a few 1e-16 in all of them. Not a
// number where an element is not: ask is_finite() first.

/// How far rows and columns are from being orthonormal: the Frobenius norm of Aᵀ A − E. Properties 1 and 3, the six
/// conditions 1-9 and 1-10. 0 for a rotation and for a reflection.
[[nodiscard]] double orthogonality_error(const Matrix3x3& a);

/// How far the elements are from their own cofactors: the Frobenius norm of A − cofactors(A). Property 5, the book's
/// equation 1-13 for all nine. 0 for a rotation and the null matrix only.
[[nodiscard]] double cofactor_error(const Matrix3x3& a);

/// A is a rotation to within the tolerance: finite, orthogonality_error() at most `most`, determinant positive
/// (property 4: +1 for right-handed frames).
[[nodiscard]] bool is_rotation(const Matrix3x3& a, double most = tolerance::rotation_matrix);

/// The cosine of the angle of the turn by the trace: tr A = 1 + 2 cos θ. Exact to 1e-16 itself, but its arc cosine
/// loses half of the digits near 0 and π: use axis_angle.hpp for the angle.
[[nodiscard]] double cosine_by_trace(const Matrix3x3& a);

/// Euler's theorem, constructively: every rotation has the eigenvalue 1, and its eigenvector is the axis.
struct EigenvalueOne {
  Vector3 axis{0, 0, 1};     ///< unit vector, the same coordinates in frames i and j; its sign is that of the turn
  bool axis_defined = true;  ///< false for the identity: every vector is an eigenvector, (0, 0, 1) stands for them
  double determinant = 0;    ///< of A − E: 0 when 1 is an eigenvalue
  double residual = 0;       ///< length of A p − p
};

/// By the adjugate of A − E: for a matrix of rank 2 it is a multiple of p pᵀ, 2 (1 − cos θ) p pᵀ for a rotation. Its
/// largest row is the axis, up to the sign, which is taken from sin θ p, or at a half-turn as for the canonical
/// quaternion. From the quaternion's A − E, so that no digits are lost for small turns.
[[nodiscard]] EigenvalueOne eigenvalue_one(const Rotation& rotation);

}  // namespace linkwright
