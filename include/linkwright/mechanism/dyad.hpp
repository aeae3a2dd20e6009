#pragma once

#include <string_view>

#include "linkwright/algebra/homogeneous.hpp"

namespace linkwright {

/// A grounded link: the centre point (fixed pivot) and the circle point (moving pivot, as it lies in position 1), both
/// in the fixed frame and homogeneous. Centre at infinity: the moving pivot slides on a fixed line normal to (x, y).
/// Circle point at infinity: a guide of the body, normal to (x, y) in position 1, slides through the fixed pivot.
struct Dyad {
  Homogeneous center;
  Homogeneous circle;
  double coordinate = 0;  ///< τ, the place on the curve of dyads (identity of the dyad)
};

/// One of the two pivots of a grounded link: the fixed one, or the one on the body as it lies in position 1.
enum class PivotKind { ground, moving };
/// "ground", "moving".
[[nodiscard]] constexpr std::string_view name(PivotKind kind) {
  return kind == PivotKind::ground ? "ground" : "moving";
}

/// What stands at a coordinate that has no dyad: neither point exists, so that every pair with it is degenerate.
[[nodiscard]] inline Dyad no_dyad(double coordinate) { return {{}, {}, coordinate}; }

/// The same two points, to the last bit.
[[nodiscard]] inline bool same_points(const Dyad& a, const Dyad& b) {
  const auto same = [](Homogeneous p, Homogeneous q) { return p.w == q.w && p.x == q.x && p.y == q.y; };
  return same(a.center, b.center) && same(a.circle, b.circle);
}

}  // namespace linkwright
