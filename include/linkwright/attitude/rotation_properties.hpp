#pragma once

#include "linkwright/attitude/rotation.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

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
