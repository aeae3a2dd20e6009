#pragma once

#include "core/kernels.hpp"

namespace linkwright {

/// Some planar four-bars in the positions of a body, number by number, as a kernel reads them, and their tolerance
/// errors, as it writes them: tolerance_error() of pose_output(), or angle_output() in radians.
struct ToleranceErrorBlock {
  static constexpr int size = 8;  ///< linkages
  static constexpr int most_positions = 5;

  /// σ²; of ground pivots and point for each coordinate.
  struct Variances {
    double input = 0, coupler = 0, output = 0, ground_pivots = 0, point = 0, driver = 0;
  };
  enum Kind : unsigned char { pose, angle };
  Kind kind = pose;
  Variances variances;
  double turning_length = 0;
  int positions = 0;
  double point[most_positions][2] = {};  ///< of poses, the body's origin

  alignas(64) double input_fixed[2][size], output_fixed[2][size];
  alignas(64) double input_moving[most_positions][2][size], output_moving[most_positions][2][size];

  alignas(64) double error[size];  ///< infinite at a dead point
};

LINKWRIGHT_DECLARE_KERNELS(tolerance_error_kernel, ToleranceErrorBlock&);

}  // namespace linkwright
