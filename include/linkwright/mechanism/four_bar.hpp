#pragma once

#include <algorithm>
#include <string_view>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Lengths of the four links, user's unit.
struct LinkLengths {
  double ground = 0, input = 0, coupler = 0, output = 0;

  [[nodiscard]] double perimeter() const { return ground + input + coupler + output; }
  [[nodiscard]] double longest() const { return std::max({ground, input, coupler, output}); }
  [[nodiscard]] double shortest() const { return std::min({ground, input, coupler, output}); }
  /// The same bars driven from the other grounded link.
  [[nodiscard]] LinkLengths swapped() const { return {ground, output, coupler, input}; }
};

/// A planar four-bar as it lies in position 1, fixed frame: the input (driving) grounded link turns about
/// `input_fixed` and carries `input_moving`; the output link likewise; the coupler joins the two circle points.
struct FourBar {
  Point input_fixed{}, input_moving{}, output_fixed{}, output_moving{};

  /// Distances of the pivots, user's unit.
  [[nodiscard]] LinkLengths lengths() const {
    return {std::abs(output_fixed - input_fixed), std::abs(input_moving - input_fixed),
            std::abs(output_moving - input_moving), std::abs(output_moving - output_fixed)};
  }
  /// The same bars driven from the other grounded link.
  [[nodiscard]] FourBar swapped() const { return {output_fixed, output_moving, input_fixed, input_moving}; }

  friend bool operator==(const FourBar&, const FourBar&) = default;
};

/// Largest distance between the pivots of two four-bars, the grounded links named whichever way is nearer.
[[nodiscard]] inline double farthest_pivot(const FourBar& a, const FourBar& b) {
  const auto farthest = [](const FourBar& one, const FourBar& other) {
    return std::max({std::abs(one.input_fixed - other.input_fixed), std::abs(one.input_moving - other.input_moving),
                     std::abs(one.output_fixed - other.output_fixed),
                     std::abs(one.output_moving - other.output_moving)});
  };
  return std::min(farthest(a, b), farthest(a, b.swapped()));
}

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

/// A four-bar and the point of its coupler whose path is looked at, both as they lie; fixed frame.
struct TracingFourBar {
  FourBar bars;
  Point point{};

  /// Of the four links and of both arms of the point, which have to be built as well.
  [[nodiscard]] double longest() const {
    return std::max(
        {bars.lengths().longest(), std::abs(point - bars.input_moving), std::abs(point - bars.output_moving)});
  }
  /// Of the same.
  [[nodiscard]] double shortest() const {
    return std::min(
        {bars.lengths().shortest(), std::abs(point - bars.input_moving), std::abs(point - bars.output_moving)});
  }
  /// The same with its links as `there`, the point carried along by the coupler.
  [[nodiscard]] TracingFourBar moved_to(const FourBar& there) const {
    const auto coupler = [](const FourBar& at) {
      return Pose{at.input_moving, std::arg(at.output_moving - at.input_moving)};
    };
    return {there, displaced(point, coupler(bars), coupler(there))};
  }
  /// The same, driven from the other grounded link.
  [[nodiscard]] TracingFourBar swapped() const { return {bars.swapped(), point}; }
};

}  // namespace linkwright
