#pragma once

#include <cstddef>

#include "core/kernels.hpp"

namespace linkwright {

/// Some four-bars with a point on a line, number by number, as a kernel reads them; and their paths beside the line,
/// step by step both ways, as it writes them.
struct LineTraceBlock {
  static constexpr std::size_t size = 8;  ///< linkages
  static constexpr int most_steps = 128;
  static constexpr int samples = 2 * most_steps + 1;

  double direction[2] = {1, 0};  ///< of the line, unit vector
  int contact = 4;               ///< points of contact: terms before s^contact are not there
  double half_stroke = 0;        ///< that is traced at least, where the point goes as far
  int steps = 32;                ///< either way, longer and longer, up to most_steps
  double growth = 1.1;           ///< of a step over the one before
  int tries = 1;                 ///< of each step, shorter and shorter

  alignas(64) double input_fixed[2][size], input_moving[2][size], output_fixed[2][size],
      output_moving[2][size], point[2][size];
  double deviation[size];  ///< δ; the path is traced to 2 δ

  double coefficient[size];  ///< of s^contact
  /// By rising s, with the turn of the input; derivatives by the way of the turns; the signed sine of the transmission
  /// angle.
  double s[samples][size], e[samples][size], turn[samples][size], ds[samples][size], de[samples][size],
      dturn[samples][size], sine[samples][size];
  double step[samples][size];     ///< way of the turns from the next sample towards the middle
  short first[size], last[size];  ///< samples from where to where the point goes on along the line
  bool doubtful[size];            ///< the path goes on, or a step was too long for it
};

LINKWRIGHT_DECLARE_KERNELS(line_trace_kernel, LineTraceBlock&);

}  // namespace linkwright
