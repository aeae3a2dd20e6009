#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "linkwright/approximate/timed_fit.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/planar/path_task.hpp"

namespace linkwright {

/// As mistakes_in(), of a task that is_approximate().
[[nodiscard]] std::vector<Error> mistakes_in_nearest(const PathTask& task);

/// Those of mistakes_in() about angles of the crank: equal ones, and ones that do not go one way within a turn.
[[nodiscard]] std::vector<Error> mistakes_in_crank_angles(const PathTask& task);

/// What a path is to pass near, and of each of its points which of the task it is.
struct NearestTarget {
  static constexpr auto between = static_cast<std::size_t>(-1);

  CurveTarget target;
  std::optional<CurveTiming> timing;  ///< nothing: free
  std::vector<std::size_t> point;     ///< index in the task, rising; `between`: a middle of a side of the polygon
  std::vector<double> tolerance;      ///< infinite where none is given
  GroundPivots pivots;                ///< that are given
  std::vector<Notice> warnings;       ///< points that were left out: equal neighbours, a closed path's first at its end

  /// Of a fit of the target, by the points of the task alone; its max_at is one of them.
  [[nodiscard]] CurveError error_of(const CurveFit& fit) const;

  /// Of the task, those left out not counted.
  [[nodiscard]] std::size_t point_count() const {
    return point.size() - static_cast<std::size_t>(std::count(point.begin(), point.end(), between));
  }
};
/// Of a task without mistakes. A tolerance t weighs 1/t², beside weights that are given.
[[nodiscard]] NearestTarget nearest_target(const PathTask& task);

}  // namespace linkwright
