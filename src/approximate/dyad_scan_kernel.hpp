#pragma once

#include "core/kernels.hpp"

namespace linkwright {

/// Driving dyads at one fixed pivot, a lane to each: they turn the points of a target into poses of the coupler, to
/// which the second dyad is fitted (dyad_scan.hpp). As a kernel reads and writes them; the fixed pivot is the origin.
struct DyadBlock {
  static constexpr int size = 256, most_points = 24, numbers = 7;

  // Of all dyads.
  int count = 0;   ///< lanes beyond it are worked on, too, up to the next multiple of 8, and mean nothing
  int points = 0;  ///< of the target
  double direction[most_points][2];  ///< to each point, a unit vector
  double distance[most_points];      ///< > 0
  double weight[most_points];

  // Of each.
  alignas(64) double input[size], arm[size];  ///< lengths: of the link, and from the moving pivot to the point
  alignas(64) long long assembly[size];       ///< bit j: at point j the moving pivot lies to the right of its direction

  /// The two smallest eigenvalues of the mean of the squared rows, and their unit vectors.
  alignas(64) double value[2][size];
  alignas(64) double vector[2][numbers][size];
};

LINKWRIGHT_DECLARE_KERNELS(dyad_scan_kernel, DyadBlock&);

}  // namespace linkwright
