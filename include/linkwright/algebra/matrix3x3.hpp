#pragma once

#include <array>
#include <cstddef>

#include "linkwright/algebra/vector3.hpp"

namespace linkwright {

/// A 3×3 matrix over the coordinates x, y, z of space (HomogeneousMatrix in homogeneous.hpp is the plane's, over w, x,
/// y).
struct Matrix3x3 {
  std::array<Vector3, 3> row{};

  [[nodiscard]] static constexpr Matrix3x3 identity() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }
  /// Of a rotation C_ij: the axes of frame j written in i.
  [[nodiscard]] static constexpr Matrix3x3 of_columns(Vector3 a, Vector3 b, Vector3 c) {
    return {{{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}}};
  }

  /// Row i, column j, from 0.
  [[nodiscard]] constexpr double operator()(std::size_t i, std::size_t j) const { return row[i][j]; }
  [[nodiscard]] constexpr double& operator()(std::size_t i, std::size_t j) { return row[i][j]; }
  [[nodiscard]] constexpr Vector3 column(std::size_t j) const { return {row[0][j], row[1][j], row[2][j]}; }

  friend constexpr bool operator==(const Matrix3x3&, const Matrix3x3&) = default;
};

[[nodiscard]] constexpr Matrix3x3 operator+(const Matrix3x3& a, const Matrix3x3& b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
[[nodiscard]] constexpr Matrix3x3 operator-(const Matrix3x3& a, const Matrix3x3& b) {
  return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
}
[[nodiscard]] constexpr Matrix3x3 operator*(double s, const Matrix3x3& a) {
  return {{s * a.row[0], s * a.row[1], s * a.row[2]}};
}
[[nodiscard]] constexpr Vector3 operator*(const Matrix3x3& a, Vector3 v) {
  return {dot(a.row[0], v), dot(a.row[1], v), dot(a.row[2], v)};
}
/// vᵀ A as a vector.
[[nodiscard]] constexpr Vector3 operator*(Vector3 v, const Matrix3x3& a) {
  return v.x * a.row[0] + v.y * a.row[1] + v.z * a.row[2];
}
[[nodiscard]] constexpr Matrix3x3 operator*(const Matrix3x3& a, const Matrix3x3& b) {
  return {{a.row[0] * b, a.row[1] * b, a.row[2] * b}};
}
[[nodiscard]] constexpr Matrix3x3 transposed(const Matrix3x3& a) {
  return Matrix3x3::of_columns(a.row[0], a.row[1], a.row[2]);
}
[[nodiscard]] constexpr double determinant(const Matrix3x3& a) { return determinant(a.row[0], a.row[1], a.row[2]); }
[[nodiscard]] constexpr double trace(const Matrix3x3& a) { return a.row[0].x + a.row[1].y + a.row[2].z; }

/// Each element's cofactor (signed minor), in the element's place: A · cofactors(A)ᵀ = det A · E.
[[nodiscard]] constexpr Matrix3x3 cofactors(const Matrix3x3& a) {
  return {{cross(a.row[1], a.row[2]), cross(a.row[2], a.row[0]), cross(a.row[0], a.row[1])}};
}

/// The dyadic product a bᵀ: applied to c it gives a (b·c).
[[nodiscard]] constexpr Matrix3x3 dyadic_product(Vector3 a, Vector3 b) { return {{a.x * b, a.y * b, a.z * b}}; }

/// The skew-symmetric matrix [p]× of the cross product: [p]× a = p × a.
[[nodiscard]] constexpr Matrix3x3 skew_matrix(Vector3 p) {
  return {{{{0, -p.z, p.y}, {p.z, 0, -p.x}, {-p.y, p.x, 0}}}};
}

/// The p whose [p]× is the skew-symmetric part ½(A − Aᵀ) of A.
[[nodiscard]] constexpr Vector3 axial_vector(const Matrix3x3& a) {
  return 0.5 * Vector3{a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1)};
}

/// The Frobenius norm: root of the sum of the squares of the elements.
[[nodiscard]] inline double frobenius_norm(const Matrix3x3& a) {
  return norm(Vector3{norm(a.row[0]), norm(a.row[1]), norm(a.row[2])});
}

/// All nine elements are finite numbers.
[[nodiscard]] inline bool is_finite(const Matrix3x3& a) {
  return is_finite(a.row[0]) && is_finite(a.row[1]) && is_finite(a.row[2]);
}

}  // namespace linkwright
