#pragma once

#include <vector>

#include "approximate/pose_least_squares.hpp"
#include "approximate/pose_target.hpp"

namespace linkwright {

/// How much is tried.
struct PoseSearchEffort {
  std::size_t valleys;  ///< points of the field's valleys
  std::size_t pairs;    ///< pairs of dyads, and
  std::size_t strewn;   ///< linkages from anywhere, that least squares start from
  std::size_t middle;   ///< of the starts that go on after some iterations, and
  std::size_t kept;     ///< to the end
};
[[nodiscard]] PoseSearchEffort pose_search_effort(FitEffort effort);

struct PoseSearch {
  std::vector<BodyStart> minima;  ///< on all poses, in the frame of the fit; distinct
  std::vector<BodyStart> given;   ///< what it began with, within the limits as it is
  std::size_t dyads = 0, starts = 0;
  bool cancelled = false;
};

/// Local minima of the error at the poses, by least squares from the best pairs of dyads.
[[nodiscard]] PoseSearch search_poses(const PoseTarget& target, const PoseFrame& frame, const FitLimits& limits,
                                      const PoseFitOptions& options, const Progress& progress);

/// Where a defect keeps the nearest of the minima from being driven: fits again from the best of them, their states
/// assigned anew, in turn along one circuit and on one side of the dead points.
[[nodiscard]] std::vector<BodyStart> fit_in_turn(const std::vector<BodyStart>& minima, const PoseTarget& target,
                                                 const PoseFrame& frame, const FitLimits& limits,
                                                 const PoseFitOptions& options, const Progress& progress);

}  // namespace linkwright
