#pragma once

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// A four-bar and the point of its coupler whose path is looked at, both as they lie; fixed frame.
struct TracingFourBar {
  FourBar bars;
  Point point{};

  /// Of the four links and of both arms of the point, which have to be built as well.
  [[nodiscard]] double longest() const {
    return std::max(
        {bars.lengths().longest(), std::abs(point - bars.input_circle), std::abs(point - bars.output_circle)});
  }
  /// Of the same.
  [[nodiscard]] double shortest() const {
    return std::min(
        {bars.lengths().shortest(), std::abs(point - bars.input_circle), std::abs(point - bars.output_circle)});
  }
  /// The same with its links as `there`, the point carried along by the coupler.
  [[nodiscard]] TracingFourBar moved_to(const FourBar& there) const {
    const auto coupler = [](const FourBar& at) {
      return Pose{at.input_circle, std::arg(at.output_circle - at.input_circle)};
    };
    return {there, displaced(point, coupler(bars), coupler(there))};
  }
  /// The same, driven from the other grounded link.
  [[nodiscard]] TracingFourBar swapped() const { return {bars.swapped(), point}; }
};

}  // namespace linkwright
