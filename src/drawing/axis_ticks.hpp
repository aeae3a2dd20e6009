#pragma once

#include <string>
#include <vector>

#include "linkwright/region/linkage_family.hpp"
#include "region_scale.hpp"

namespace linkwright {

struct AxisTick {
  double px = 0;  ///< from the start of the axis
  std::string text;
};

/// Round values along an axis of a map on which numbers are read (has_values); none on others. They leave room for the
/// places where a pivot is at infinity.
[[nodiscard]] std::vector<AxisTick> axis_ticks(const RegionScale& scale, const LinkageFamily& family, Side side);

/// Round values between low and high, evenly spaced, at least `spacing` px apart on an axis of `length` px; of angles
/// in degrees. At most some thousand; none where the two ends are so far out that numbers between them run out.
[[nodiscard]] std::vector<double> even_ticks(double low, double high, double length, double spacing, bool are_degrees);

}  // namespace linkwright
