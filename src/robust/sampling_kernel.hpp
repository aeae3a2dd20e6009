#pragma once

#include "core/kernels.hpp"

namespace linkwright {

/// The errors of some samples' parameters, as a kernel draws them.
struct DrawBlock {
  static constexpr int size = 128;  ///< samples
  static constexpr int most_parameters = 16;
  enum Distribution : int { normal, truncated_normal, uniform };

  unsigned long long seed = 1;
  unsigned long long first = 0;  ///< number of the first sample
  Distribution distribution = normal;
  int parameters = 0;
  int pinned = 0;  ///< lengths between two pins, the first parameters
  double half_tolerance[most_parameters] = {};
  double clearance = 0;  ///< of each pin

  alignas(64) double deviation[most_parameters][size];
};

/// Some samples of a linkage: the errors of their parameters, and their errors in each position, as a kernel leaves
/// them.
struct SampledBlock {
  static constexpr int size = DrawBlock::size;
  static constexpr int most_positions = 64;

  int positions = 0;
  bool driver_errs = false;
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

/// One planar four-bar. A position: the input's direction, and what the point and an angle are to be there.
struct SamplingBlock : SampledBlock {
  enum Kind : int { pose, angle, line };

  double input = 0, coupler = 0, output = 0;
  double input_fixed[2] = {}, output_fixed[2] = {};
  double arm[2] = {};  ///< of the point, along and across the coupler

  Kind kind = pose;
  /// Squared errors of poses: point's and angle's, for the error and for the limit.
  double error_of_point = 1, error_of_angle = 0, limit_of_point = 1, limit_of_angle = 0;
  double line_point[2] = {}, line_left[2] = {};
  bool realigned = false;

  double input_direction[most_positions][2] = {};
  double assembly[most_positions] = {};  ///< ± 1
  double point[most_positions][2] = {};
  double direction[most_positions][2] = {};  ///< of the coupler, or of the output where its angle is judged
  double nominal[most_positions] = {};       ///< distance from the line
  /// Places along the line from their middle, over the root of the sum of their squares.
  double place[most_positions] = {};
};

/// One spherical four-bar: arcs in the order of SphericalParameter, the first fixed axis, and the direction at right
/// angles to it in which the ground's arc goes off. A position: the direction in which the input's arc goes off, and
/// three unit vectors at right angles fast to the coupler, or the output's direction seen along its fixed axis.
struct SphericalSamplingBlock : SampledBlock {
  double arc[4] = {};
  double fixed_axis[3] = {}, ground[3] = {};
  bool of_output = false;  ///< the output's angle is judged

  double input_direction[most_positions][3] = {};
  double assembly[most_positions] = {};  ///< sign of det [W₁ W₂ G₂]
  double coupler[most_positions][3][3] = {};
  double output[most_positions][2] = {};
};

LINKWRIGHT_DECLARE_KERNELS(draw_kernel, DrawBlock&);
LINKWRIGHT_DECLARE_KERNELS(sampling_kernel, SamplingBlock&);
LINKWRIGHT_DECLARE_KERNELS(spherical_sampling_kernel, SphericalSamplingBlock&);

}  // namespace linkwright
