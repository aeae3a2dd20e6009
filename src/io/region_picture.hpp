#pragma once

#include "linkwright/planar/synthesis.hpp"
#include "png_image.hpp"
#include "region_scale.hpp"

namespace linkwright {

/// The cells as a picture with so many pixels per px of the scales, hatching included; row 0 is the top, the input's
/// last sample.
[[nodiscard]] PngImage region_picture(const Solution& solution, const RegionScale& input, const RegionScale& output,
                                      int pixels_per_px);
/// The same of a map that has no LinkageFamily.
[[nodiscard]] PngImage region_picture(const Solution& solution, const RequirementFilter& filter,
                                      const RegionScale& input, const RegionScale& output, int pixels_per_px);

}  // namespace linkwright
