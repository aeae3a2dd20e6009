#include "path_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

std::string place_of_path_point(std::size_t point) { return fmt::format("task.points[{}]", point); }

double extent_of(const PathTask& task) {
  double extent = 0;
  for (const PathPoint& point : task.points)
    extent = std::max(extent, std::abs(point.point - task.points.front().point));
  return extent;
}

namespace {

void check_pivot(const PathTask& task, Point pivot, const std::string& place, std::vector<Error>& found) {
  check_number(pivot.real(), "x", place + "[0]", found);
  check_number(pivot.imag(), "y", place + "[1]", found);
  for (std::size_t i = 0; i < task.points.size() && found.empty(); ++i)
    if (task.points[i].is_plain() &&
        std::abs(task.points[i].point - pivot) <= tolerance::repeated_pose * extent_of(task))
      found.push_back({"point_at_pivot",
                       place_of_path_point(i),
                       fmt::format("point {} lies at a ground pivot that is given: a link that reaches it there would "
                                   "turn freely; move one of both",
                                   i + 1),
                       {{"i", i + 1}}});
}

}  // namespace

void check_pivots(const PathTask& task, std::vector<Error>& found) {
  const std::string place = "task.given.ground_pivots";
  if (task.pivots.input) check_pivot(task, *task.pivots.input, place + ".input", found);
  if (task.pivots.output) check_pivot(task, *task.pivots.output, place + ".output", found);
  if (task.pivots.count() == 2 && found.empty() &&
      std::abs(*task.pivots.input - *task.pivots.output) <= tolerance::repeated_pose * extent_of(task))
    found.push_back({"pivots_at_one_place", place,
                     "both ground pivots lie at one place: there is no ground link; move one of them"});
}

}  // namespace linkwright
