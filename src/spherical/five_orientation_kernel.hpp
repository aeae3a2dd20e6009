#pragma once

#include <cstdint>

#include "core/kernels.hpp"

namespace linkwright {

/// Some tasks of five finite orientations and their dyads, number by number, as a kernel reads and writes them.
struct FiveOrientationBlock {
  static constexpr int size = 64;

  alignas(64) double quaternion[5][4][size];  ///< w, x, y, z of each orientation, unit length

  double fixed[6][3][size], moving[6][3][size];  ///< unit vectors of each place
  std::uint8_t real[6][size];                    ///< 1 where the place is a dyad; the first ones are
  std::uint8_t sure[size];                       ///< 0 where a decision was too close: what is written means nothing
};

LINKWRIGHT_DECLARE_KERNELS(five_orientation_kernel, FiveOrientationBlock&);

}  // namespace linkwright
