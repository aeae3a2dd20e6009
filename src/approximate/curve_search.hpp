#pragma once

#include <vector>

#include "approximate/curve_least_squares.hpp"
#include "approximate/dyad_scan.hpp"

namespace linkwright {

/// How much is tried.
struct SearchEffort {
  std::size_t places, starts;  ///< of a fixed pivot; of the least squares
  std::size_t clean, any;      ///< of the starts with a driver, and without, that go on to the end
  std::size_t creeping;  ///< of those that have long ground links, and of the others, that go on along flat valleys
  int creeping_iterations;
  std::size_t rounds;  ///< of the scan of a fixed pivot that is given
};
[[nodiscard]] SearchEffort search_effort(FitEffort effort);

/// The places of a fixed pivot that are scanned: on a spiral about the target whose turns leave no gaps, as seeds of a
/// sunflower lie, densely near it and ever more sparsely to nine of its radii, and turned with it; within a box where
/// there is one.
[[nodiscard]] std::vector<Point> pivot_places(std::size_t count, std::span<const Point> target,
                                              const std::optional<Box>& within);

struct CurveSearch {
  std::vector<CurveStart> minima;  ///< on all points, the least sum of squares first; distinct curves
  std::vector<CurveStart> given;   ///< what it began with, within the limits as it is
  std::size_t places = 0, starts = 0;
  bool cancelled = false;
};

/// Local minima of the distance, by least squares from the best pairs of dyads.
[[nodiscard]] CurveSearch search_curves(const ScaledTarget& target, const FitLimits& limits,
                                        const CurveFitOptions& options, const Progress& progress);

}  // namespace linkwright
