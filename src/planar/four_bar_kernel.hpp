#pragma once

#include <cstddef>
#include <cstdint>

#include "core/kernels.hpp"

namespace linkwright {

inline constexpr int max_poses = 5;

/// One axis of a region as plain arrays.
struct KernelAxis {
  const double *center_x, *center_y, *circle_x, *circle_y, *length;
  const double* arm_x[max_poses];
  const double* arm_y[max_poses];
  const std::uint8_t *admissible_directions, *at_least_half_turn;  ///< as in DyadAxis
};

/// Where cells go, row-major.
struct KernelCells {
  std::uint8_t *type, *defects;
  float *versine, *full_versine, *ratio, *longest;
  std::uint8_t* admissible_directions;  ///< of two poses: in which the task is done, ccw (bit 1), cw (bit 2), where
                                        ///< clean; may be null
};

/// Rows [row_begin, row_end) of a region.
struct KernelTask {
  KernelAxis input, output;
  std::size_t row_begin, row_end, columns;
  int poses;
  double unit;        ///< user's length of one unit of the axes
  double zero_share;  ///< tolerance::change_point
  KernelCells cells;
};

LINKWRIGHT_DECLARE_KERNELS(four_bar_kernel, const KernelTask&);

}  // namespace linkwright
