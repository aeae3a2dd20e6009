#pragma once

#include "linkwright/attitude/rotation.hpp"

namespace linkwright {

struct NearestRotation {
  Rotation rotation;
  double distance = 0;  ///< Frobenius norm of the matrix minus the rotation
  /// Other rotations are as near: rank below 2, or the two smallest singular values alike and the determinant negative
  /// (the mirror image of a turn is as near to many). One of them is given.
  bool unique = true;
};

/// The rotation C_ij that is nearest to a noisy matrix in the Frobenius norm: the orthogonal factor of its polar
/// decomposition, by the singular values U diag(1, 1, det UVᵀ) Vᵀ (Kabsch, A solution for the best rotation to relate
/// two sets of vectors, 1976; Higham, Computing the polar decomposition, 1986). Errors: `not_finite`.
[[nodiscard]] Result<NearestRotation> nearest_rotation(const Matrix3x3& c_ij);

}  // namespace linkwright
