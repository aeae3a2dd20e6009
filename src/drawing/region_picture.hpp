#pragma once

#include <functional>

#include "linkwright/synthesis/solve.hpp"
#include "png_image.hpp"
#include "region_scale.hpp"

namespace linkwright {

/// The cells as a picture with so many pixels per px of the scales, hatching included; row 0 is the top, the input's
/// last sample.
[[nodiscard]] PngImage region_picture(const Solution& solution, const RegionScale& input, const RegionScale& output,
                                      int pixels_per_px);
/// The same of a map that has no FourBarFamily; `passes`: a cell meets all requirements. Asked once a pixel.
using CellPasses = std::function<bool(std::size_t row, std::size_t column)>;
[[nodiscard]] PngImage region_picture(const Solution& solution, const CellPasses& passes, const RegionScale& input,
                                      const RegionScale& output, int pixels_per_px);

}  // namespace linkwright
