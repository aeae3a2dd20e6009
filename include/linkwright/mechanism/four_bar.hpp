#pragma once

#include <algorithm>

#include "linkwright/algebra/point.hpp"

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
/// `input_center` and carries `input_circle`; the output link likewise; the coupler joins the two circle points.
struct FourBar {
  Point input_center{}, input_circle{}, output_center{}, output_circle{};

  /// Distances of the pivots, user's unit.
  [[nodiscard]] LinkLengths lengths() const {
    return {std::abs(output_center - input_center), std::abs(input_circle - input_center),
            std::abs(output_circle - input_circle), std::abs(output_circle - output_center)};
  }
  /// The same bars driven from the other grounded link.
  [[nodiscard]] FourBar swapped() const { return {output_center, output_circle, input_center, input_circle}; }
};

/// Largest distance between the pivots of two four-bars, the grounded links named whichever way is nearer.
[[nodiscard]] inline double farthest_pivot(const FourBar& a, const FourBar& b) {
  const auto farthest = [](const FourBar& one, const FourBar& other) {
    return std::max({std::abs(one.input_center - other.input_center), std::abs(one.input_circle - other.input_circle),
                     std::abs(one.output_center - other.output_center),
                     std::abs(one.output_circle - other.output_circle)});
  };
  return std::min(farthest(a, b), farthest(a, b.swapped()));
}

}  // namespace linkwright
