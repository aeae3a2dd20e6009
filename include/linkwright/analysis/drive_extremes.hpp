#pragma once

#include <optional>

#include "linkwright/analysis/position.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// Where a transmission angle is largest. Radians.
struct TransmissionPeak {
  double angle = 0, input_angle = 0;
};

/// Over a range of the input: exact, π/2 where coupler and output link come to stand at right angles, else where the
/// diagonal has an extreme or the range ends. 0 for links that are none.
[[nodiscard]] TransmissionPeak largest_transmission_angle(const LinkLengths& lengths, const AngleRange& range);

/// Least and largest ratio of the angular velocities of output and input.
struct RatioRange {
  double least = 0, most = 0;
};

/// Over the turn of a crank in one assembly; nothing where it passes a dead point, or the input is no crank.
[[nodiscard]] std::optional<RatioRange> output_rates_full_turn(const LinkLengths& lengths, Assembly assembly);

}  // namespace linkwright
