#include "support/arm_maps.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "planar/task_curve.hpp"

namespace linkwright::testing {

Requirements anything() {
  Requirements wanted;
  wanted.no_defects = false;
  wanted.max_link_ratio = wanted.min_length.emplace(0) + Requirements::unlimited;
  wanted.max_length = Requirements::unlimited;
  return wanted;
}

std::shared_ptr<const ArmFamily> arms_of(const PathTask& task, const Requirements& wanted) {
  EXPECT_TRUE(mistakes_in(task).empty());
  ArmTask arms = arm_task(task);
  auto choice = arm_choice(task, arms).choice;
  EXPECT_TRUE(choice);
  return std::make_shared<const ArmFamily>(std::move(arms), std::move(choice), wanted,
                                           Objective::min_transmission_angle);
}

MapPoint place_of(const PathTask& task, double link, double reach) {
  const Point pivot = task.pivots.input ? *task.pivots.input : *task.pivots.output;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const PathPoint& point : task.points) {
    nearest = std::min(nearest, std::abs(point.point - pivot));
    farthest = std::max(farthest, std::abs(point.point - pivot));
  }
  return {farthest / (link + reach), ((reach - link) / nearest + 1) / 2};
}

MapPoint place_of(const PathTask& task, Point pivot) {
  Point middle{};
  for (const PathPoint& point : task.points) middle += point.point / static_cast<double>(task.points.size());
  const Point from_middle = (pivot - middle) / arm_task(task).frame.scale;
  const auto coordinate = [](double value) { return 0.5 + std::atan(value) / pi; };
  return {coordinate(from_middle.imag()), coordinate(from_middle.real())};
}

double curve_coordinate_of(const PathTask& task, Point circle_point) {
  const TaskCurve found = task_curve({angled_poses(task), {}, {}, {}, {}});
  return found.curve->coordinate_of(Homogeneous::of(found.conditions.frame.to_working(circle_point))).value();
}

double off(const FourBar& a, const FourBar& b) {
  return std::max({std::abs(a.input_fixed - b.input_fixed), std::abs(a.input_moving - b.input_moving),
                   std::abs(a.output_fixed - b.output_fixed), std::abs(a.output_moving - b.output_moving)});
}

FourBar nearest_of(const std::vector<Cell>& cells, const FourBar& wanted) {
  FourBar nearest{};
  double least = std::numeric_limits<double>::infinity();
  for (const Cell& cell : cells) {
    const FourBar bars = four_bar_of(cell.pivots);
    if (off(bars, wanted) < least) {
      least = off(bars, wanted);
      nearest = bars;
    }
  }
  return nearest;
}

}  // namespace linkwright::testing
