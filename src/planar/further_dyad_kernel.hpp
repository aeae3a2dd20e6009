#pragma once

#include <cstdint>

#include "core/kernels.hpp"

namespace linkwright {

/// Some tasks of five positions one of whose dyads is known, and their further ones, number by number, as a kernel
/// reads and writes them. Working frames.
struct FurtherDyadBlock {
  static constexpr int size = 64, most = 3;

  int count = 0;                                        ///< lanes beyond it are worked on, too, and mean nothing
  alignas(64) double row[4][7][size];                   ///< conditions, as ConditionRow
  alignas(64) double known_circle[2][size];             ///< x, y of the known dyad's circle point
  alignas(64) double known_center[2][size];             ///< and of its centre
  double circle[most][3][size], center[most][3][size];  ///< unit vectors (w, x, y), w ≥ 0
  std::uint8_t real[most][size];                        ///< 1 where the place is a dyad
};

LINKWRIGHT_DECLARE_KERNELS(further_dyad_kernel, FurtherDyadBlock&);

}  // namespace linkwright
