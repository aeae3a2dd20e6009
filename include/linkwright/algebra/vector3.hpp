#pragma once

#include <cmath>
#include <cstddef>

#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// A vector of space by its coordinates in some right-handed Cartesian frame: which one, the caller says.
struct Vector3 {
  double x = 0, y = 0, z = 0;

  /// Coordinate 0, 1 or 2.
  [[nodiscard]] constexpr double operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
  [[nodiscard]] constexpr double& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }

  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

[[nodiscard]] constexpr Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] constexpr Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] constexpr Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
[[nodiscard]] constexpr Vector3 operator*(double s, Vector3 a) { return {s * a.x, s * a.y, s * a.z}; }
[[nodiscard]] constexpr Vector3 operator/(Vector3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
[[nodiscard]] constexpr double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The triple product a·(b × c): the determinant of the three as columns.
[[nodiscard]] constexpr double determinant(Vector3 a, Vector3 b, Vector3 c) { return dot(a, cross(b, c)); }

/// A point of the plane z = 0.
[[nodiscard]] inline Vector3 in_space(Point p) { return {p.real(), p.imag(), 0}; }

/// Length; does not overflow or underflow where the result does not. Not a number where a coordinate is not, which is
/// more than g++ 12's std::hypot of three numbers says.
[[nodiscard]] inline double norm(Vector3 a) {
  const double square = dot(a, a);
  if (square > 1e-280 && square < 1e300) return std::sqrt(square);
  return std::hypot(std::hypot(a.x, a.y), a.z);
}

/// All three coordinates are finite numbers.
[[nodiscard]] inline bool is_finite(Vector3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Unit length; the null vector stays null. Any finite length, the smallest and the largest doubles included.
[[nodiscard]] inline Vector3 normalized(Vector3 a) {
  const double largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
  if (!(largest > 0)) return a;
  const int exponent = std::ilogb(largest);
  const Vector3 scaled{std::scalbn(a.x, -exponent), std::scalbn(a.y, -exponent), std::scalbn(a.z, -exponent)};
  return scaled / std::sqrt(dot(scaled, scaled));
}

/// The angle between two directions, in [0, π]; as exact near 0 and π as elsewhere. 0 if one of them is null.
[[nodiscard]] inline double angle_between(Vector3 a, Vector3 b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

}  // namespace linkwright
