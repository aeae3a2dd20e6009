#pragma once

#include <cstddef>
#include <cstdint>

#include "core/kernels.hpp"

namespace linkwright {

inline constexpr int max_orientations = 5;

/// One axis of a region of spherical four-bars as plain arrays over its samples.
struct SphericalKernelAxis {
  const double* fixed[3];
  const double* moving[max_orientations][3];
  const double* normal[max_orientations][3];  ///< fixed × moving
  const double *half_sine, *half_cosine;
  const std::uint8_t *admissible_directions, *at_least_half_turn;  ///< as in SphericalAxis
};

/// Where cells go, row-major.
struct SphericalKernelCells {
  std::uint8_t *type, *defects;
  float *versine, *full_versine, *least, *largest;  ///< all as versines
  std::uint8_t* admissible_directions;  ///< of two orientations: in which the task is done, where clean; may be null
};

/// Rows [row_begin, row_end) of a region.
struct SphericalKernelTask {
  SphericalKernelAxis input, output;
  std::size_t row_begin, row_end, columns;
  int orientations;
  double zero_share;  ///< tolerance::change_point
  SphericalKernelCells cells;
};

LINKWRIGHT_DECLARE_KERNELS(spherical_kernel, const SphericalKernelTask&);

}  // namespace linkwright
