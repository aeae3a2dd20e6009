#pragma once

#include <array>
#include <vector>

#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright {

/// A target in the frame in which it is fitted: centroid at 0, root mean square radius 1; weights have a mean of 1.
struct ScaledTarget {
  Point centroid{};
  double radius = 1;  ///< user's unit
  double mean_weight = 1;
  double diagonal = 1;  ///< over the radius
  bool closed = false;
  std::vector<Point> points;
  std::vector<double> weights;
  /// The few points, 24 at most, that stand for all where starts are looked for: indices, ascending.
  std::vector<std::size_t> chosen;

  [[nodiscard]] Point scaled(Point user) const { return (user - centroid) / radius; }
  [[nodiscard]] TracingFourBar scaled_linkage(const TracingFourBar& user) const {
    const FourBar& bars = user.bars;
    return {
        {scaled(bars.input_fixed), scaled(bars.input_moving), scaled(bars.output_fixed), scaled(bars.output_moving)},
        scaled(user.point)};
  }
  [[nodiscard]] Point in_user_frame(Point scaled) const { return centroid + radius * scaled; }
  [[nodiscard]] std::vector<Point> chosen_points() const;
  [[nodiscard]] std::vector<double> chosen_weights() const;
};

[[nodiscard]] ScaledTarget scaled_target(const CurveTarget& target);

/// Up to `count` of the points, by equal steps of half the length and half the turning of the polygon through them: by
/// length alone the tips of a crescent would be lost.
[[nodiscard]] std::vector<std::size_t> chosen_points(const CurveTarget& target, std::size_t count);

}  // namespace linkwright
