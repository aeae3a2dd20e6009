#pragma once

#include "core/kernels.hpp"

namespace linkwright {

/// Shapes of four-bars at angles of their ground link, a lane to each: the point of the coupler that comes nearest to
/// the points of a target at given angles of the input is a linear problem (timed_scan.hpp). As a kernel reads and
/// writes them.
struct TimedBlock {
  static constexpr int size = 256, most_points = 24, variants = 4;
  static constexpr double unreached = 1e300;

  // Of all cells.
  int count = 0;          ///< lanes beyond it are worked on, too, up to the next multiple of 8, and mean nothing
  int points = 0;         ///< of the target
  bool absolute = false;  ///< the input's direction is prescribed, and not only its turns; variants 0 and 1 alone count
  double turn[most_points][2];   ///< unit numbers of the input's angles
  double point[most_points][2];  ///< of the target; their weighted mean is 0
  double weight[most_points];    ///< sum 1

  // Of each: lengths in inputs, and the angle of the input at turn 1 from the ground link, as a unit number.
  alignas(64) double ground[size], coupler[size], output[size];
  alignas(64) double phase[2][size];

  /// Weighted sums of squared distances, `unreached` where the loop does not close at all points. The coupler to the
  /// left and to the right of the diagonal; likewise for the mirrored target, which stands for the other sense.
  alignas(64) double squares[variants][size];
};

LINKWRIGHT_DECLARE_KERNELS(timed_scan_kernel, TimedBlock&);

}  // namespace linkwright
