#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/approximate/timed_fit.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/planar/fitted_path.hpp"
#include "linkwright/planar/path_task.hpp"

namespace linkwright {

/// Points that the path of a linkage is compared with.
struct ComparedPath {
  CurveTarget target;
  std::optional<CurveTiming> timing;  ///< nothing: free
  std::vector<std::size_t> point;     ///< index in the file, from 0, rising: points that repeat others are left out
};

/// The points of a path task, exact or near, with their angles of the crank, weights and `closed`; what else it gives
/// does not count. Mistakes as of a path that passes near its points.
[[nodiscard]] Result<ComparedPath> compared_path(const PathTask& task);
/// Points alone; `closed`: the path goes on from the last to the first.
[[nodiscard]] Result<ComparedPath> compared_path(const std::vector<Point>& points, bool closed);

/// How near the path of a linkage comes to points.
struct PathComparison {
  FittedPath path;   ///< its one realisation is the linkage at the first point
  CurveDrive drive;  ///< with its input as the driver
  CurveTarget target;
  Point first_place{};  ///< of the coupler point at the first point
};

/// On the circuit in which the linkage lies. `point`: of the coupler as it lies, instead of the file's. A linkage
/// without a point, one that cannot be moved and one whose input does not reach the angles are mistakes:
/// `no_coupler_point`, `linkage_stands`, `angles_out_of_reach`.
[[nodiscard]] Result<PathComparison> compare_with_path(const StoredLinkage& linkage, const std::optional<Point>& point,
                                                       const ComparedPath& path);

/// A line to each point: number, x and y, where the path is nearest, the distance and the input's turn from the first
/// point in degrees; comma-separated, with a heading.
[[nodiscard]] std::string comparison_table(const PathComparison& comparison);

}  // namespace linkwright
