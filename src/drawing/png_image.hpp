#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace linkwright {

/// A picture of at most 256 colours.
struct PngImage {
  std::size_t width = 0, height = 0;
  std::vector<std::uint32_t> colors;  ///< 0xRRGGBB; colour 0 is fully transparent
  std::vector<std::uint8_t> pixels;   ///< index of the colour, row by row from the top

  /// The file (PNG, ISO/IEC 15948), palette and deflate; empty where zlib cannot get memory.
  [[nodiscard]] std::vector<std::uint8_t> file() const;
};

}  // namespace linkwright
