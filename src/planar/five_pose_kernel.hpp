#pragma once

#include <cstdint>

#include "core/kernels.hpp"

namespace linkwright {

/// Some tasks of five finite poses and their dyads, number by number, as a kernel reads and writes them.
struct FivePoseBlock {
  static constexpr int size = 64;

  alignas(64) double x[5][size], y[5][size], angle[5][size];  ///< of each pose; user's unit, radians

  alignas(64) double length[size];                ///< the working frame's unit in the user's
  double circle[4][3][size], center[4][3][size];  ///< unit vectors (w, x, y) of each place, w ≥ 0; working frame
  std::uint8_t real[4][size];                     ///< 1 where the place is a dyad
  std::uint8_t sure[size];                        ///< 0 where a decision was too close: what is written means nothing
};

LINKWRIGHT_DECLARE_KERNELS(five_pose_kernel, FivePoseBlock&);

}  // namespace linkwright
