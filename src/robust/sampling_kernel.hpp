#pragma once

#include "core/kernels.hpp"

namespace linkwright {

/// The errors of some samples' parameters, as a kernel draws them.
struct DrawBlock {
  static constexpr int size = 128;       ///< samples
  static constexpr int parameters = 10;  ///< as PlanarParameter
  enum Distribution : int { normal, truncated_normal, uniform };

  unsigned long long seed = 1;
  unsigned long long first = 0;  ///< number of the first sample
  Distribution distribution = normal;
  double half_tolerance[parameters] = {};
  double clearance = 0;  ///< of each pin, added to the moving links, the first three

  alignas(64) double deviation[parameters][size];
};

/// One planar four-bar, the errors of some samples' parameters, and their errors in each position, as a kernel takes
/// them. A position: the input's direction, and what the point and an angle are to be there.
struct SamplingBlock {
  static constexpr int size = DrawBlock::size;
  static constexpr int most_positions = 64;
  enum Kind : int { pose, angle, line };

  double input = 0, coupler = 0, output = 0;
  double input_center[2] = {}, output_center[2] = {};
  double arm[2] = {};  ///< of the point, along and across the coupler
  bool driver_errs = false;

  Kind kind = pose;
  /// Squared errors of poses: point's and angle's, for the error and for the limit.
  double error_of_point = 1, error_of_angle = 0, limit_of_point = 1, limit_of_angle = 0;
  double line_point[2] = {}, line_left[2] = {};
  bool realigned = false;

  int positions = 0;
  double input_direction[most_positions][2] = {};
  double assembly[most_positions] = {};  ///< ± 1
  double point[most_positions][2] = {};
  double direction[most_positions][2] = {};  ///< of the coupler, or of the output where its angle is judged
  double nominal[most_positions] = {};       ///< distance from the line
  /// Places along the line from their middle, over the root of the sum of their squares.
  double place[most_positions] = {};

  double limit_square = 0;
  int samples = size;  ///< that count, the first ones
  const double (*deviation)[size] = nullptr;

  alignas(64) double error[most_positions][size];  ///< squared; distance from the line where there is one
  alignas(64) double worst[size];                  ///< largest error over the positions, squared
  unsigned char assembled[size / 8];               ///< in all positions: a bit each, the first sample lowest

  // Of the assembled ones together.
  double square_sum[most_positions];  ///< of errors; of what lines' differ from the nominal
  double worst_sum, worst_square_sum;
  int assembled_count, good_count;
};

LINKWRIGHT_DECLARE_KERNELS(draw_kernel, DrawBlock&);
LINKWRIGHT_DECLARE_KERNELS(sampling_kernel, SamplingBlock&);

}  // namespace linkwright
