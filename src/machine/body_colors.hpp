#pragma once

#include <array>
#include <cstddef>

namespace linkwright {

/// sRGB, in [0, 1].
using Rgb = std::array<double, 3>;

/// Of the ground, the driver and so on, over again: dark grey, blue, green, orange, violet, teal.
[[nodiscard]] constexpr Rgb body_color(int body) {
  constexpr std::array<Rgb, 6> colors = {{{0.22, 0.26, 0.31},
                                          {0.04, 0.34, 0.82},
                                          {0.18, 0.55, 0.34},
                                          {0.70, 0.28, 0.04},
                                          {0.48, 0.25, 0.60},
                                          {0.10, 0.52, 0.58}}};
  return colors[static_cast<std::size_t>(body) % colors.size()];
}

inline constexpr Rgb pin_color = {0.75, 0.76, 0.78};

}  // namespace linkwright
