#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

/// A point of the projective plane (w : x : y), scale arbitrary; w = 0 is the point at infinity in direction (x, y).
struct Homogeneous {
  double w = 0, x = 0, y = 0;

  /// The finite point p as (1, x, y).
  [[nodiscard]] static Homogeneous of(Point p) { return {1, p.real(), p.imag()}; }
  /// `direction`: of any length but zero.
  [[nodiscard]] static Homogeneous at_infinity(Point direction) { return {0, direction.real(), direction.imag()}; }

  /// (x, y): the direction of a point at infinity, of any length.
  [[nodiscard]] Point vector() const { return {x, y}; }
  friend bool operator==(const Homogeneous&, const Homogeneous&) = default;
};

[[nodiscard]] inline Homogeneous operator+(Homogeneous a, Homogeneous b) { return {a.w + b.w, a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Homogeneous operator-(Homogeneous a, Homogeneous b) { return {a.w - b.w, a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Homogeneous operator*(double s, Homogeneous a) { return {s * a.w, s * a.x, s * a.y}; }
[[nodiscard]] inline double dot(Homogeneous a, Homogeneous b) { return a.w * b.w + a.x * b.x + a.y * b.y; }
[[nodiscard]] inline double norm(Homogeneous a) { return std::sqrt(dot(a, a)); }

/// The line through two points, or the meet of two lines; null when they coincide.
[[nodiscard]] inline Homogeneous cross(Homogeneous a, Homogeneous b) {
  return {a.x * b.y - a.y * b.x, a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w};
}

/// Angle between two lines through the origin of the model space, in [0, π/2].
[[nodiscard]] inline double great_circle(Homogeneous a, Homogeneous b) {
  return std::atan2(norm(cross(a, b)), std::abs(dot(a, b)));
}

/// Unit length; the null vector stays null.
[[nodiscard]] inline Homogeneous normalized(Homogeneous a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : a;
}

/// At infinity to the tolerance of the working frame (tolerance::infinity of the vector's length).
[[nodiscard]] inline bool is_at_infinity(Homogeneous a) { return !(std::abs(a.w) > tolerance::infinity * norm(a)); }

/// The finite point, or nothing at infinity.
[[nodiscard]] inline std::optional<Point> finite_point(Homogeneous a) {
  if (is_at_infinity(a)) return std::nullopt;
  return Point{a.x / a.w, a.y / a.w};
}

/// 3×3 matrix over homogeneous coordinates; row(i) and the order w, x, y.
struct HomogeneousMatrix {
  std::array<Homogeneous, 3> row{};

  [[nodiscard]] static HomogeneousMatrix identity() { return {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }
};

[[nodiscard]] inline Homogeneous operator*(const HomogeneousMatrix& m, Homogeneous v) {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}

/// vᵀ M as a vector.
[[nodiscard]] inline Homogeneous operator*(Homogeneous v, const HomogeneousMatrix& m) {
  return v.w * m.row[0] + v.x * m.row[1] + v.y * m.row[2];
}

/// Takes lines back where M takes points: (M p)·l = p·(Mᵀ l).
[[nodiscard]] inline HomogeneousMatrix transposed(const HomogeneousMatrix& m) {
  return {{{{m.row[0].w, m.row[1].w, m.row[2].w},
            {m.row[0].x, m.row[1].x, m.row[2].x},
            {m.row[0].y, m.row[1].y, m.row[2].y}}}};
}

/// a·(b × c): zero where three points lie on one line.
[[nodiscard]] inline double determinant(Homogeneous a, Homogeneous b, Homogeneous c) { return dot(a, cross(b, c)); }

}  // namespace linkwright
