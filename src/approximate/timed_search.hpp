#pragma once

#include <vector>

#include "approximate/scan_target.hpp"
#include "approximate/timed_least_squares.hpp"
#include "linkwright/approximate/timed_fit.hpp"

namespace linkwright {

struct TimedSearch {
  std::vector<TimedStart> minima;  ///< on all points, the least sum of squares first; distinct curves
  std::vector<TimedStart> given;   ///< what it began with, within the limits as it is
  std::size_t shapes = 0, starts = 0;
  bool cancelled = false;
};

/// Local minima of the distances at the prescribed angles, by least squares from the best cells of the scan.
[[nodiscard]] TimedSearch search_timed(const ScaledTarget& target, const CurveTiming& timing, const FitLimits& limits,
                                       const CurveFitOptions& options, const Progress& progress);

}  // namespace linkwright
