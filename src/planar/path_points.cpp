#include "path_points.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace linkwright {

std::string place_of_path_point(std::size_t point) { return fmt::format("task.points[{}]", point); }

double extent_of(const PathTask& task) {
  double extent = 0;
  for (const PathPoint& point : task.points)
    extent = std::max(extent, std::abs(point.point - task.points.front().point));
  return extent;
}

}  // namespace linkwright
