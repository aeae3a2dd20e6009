#pragma once

#include <vector>

#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// The range in which the input is, shifted by whole turns to hold `angle`. The four-bar was measured as it lies, so
/// an angle outside all ranges misses one by rounding: the nearest is meant. Where rounding leaves no range, the angle
/// alone.
[[nodiscard]] AngleRange range_around(const std::vector<AngleRange>& ranges, double angle);

}  // namespace linkwright
