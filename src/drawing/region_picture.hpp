#pragma once

#include "linkwright/region/linkage_family.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "png_image.hpp"
#include "region_scale.hpp"

namespace linkwright {

/// The cells as a picture with so many pixels per px of the scales, hatching included; row 0 is the top, the input's
/// last sample.
[[nodiscard]] PngImage region_picture(const Findings& found, const LinkageFamily& family, const RegionScale& input,
                                      const RegionScale& output, int pixels_per_px);

}  // namespace linkwright
