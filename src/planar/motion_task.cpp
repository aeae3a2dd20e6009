#include "linkwright/planar/motion_task.hpp"

#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::string place_of(std::size_t pose) { return fmt::format("task.poses[{}]", pose); }

void check_number(double value, double limit, const char* what, const std::string& place, std::vector<Error>& found) {
  if (std::abs(value) <= limit) return;
  found.push_back(
      {"out_of_range", place, fmt::format("{} must be a number between −{:g} and {:g}", what, limit, limit)});
}

void check_numbers(const MotionTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.poses.size(); ++i) {
    const Pose& pose = task.poses[i].pose;
    check_number(pose.origin.real(), largest_coordinate, "x", place_of(i) + ".x", found);
    check_number(pose.origin.imag(), largest_coordinate, "y", place_of(i) + ".y", found);
    check_number(degrees(pose.angle), largest_coordinate, "theta_deg", place_of(i) + ".theta_deg", found);
  }
}

bool same_pose(const Pose& a, const Pose& b, double extent) {
  return std::abs(a.origin - b.origin) <= tolerance::repeated_pose * extent &&
         std::abs(wrap_signed(a.angle - b.angle)) <= tolerance::repeated_pose;
}

// The size of the drawing, for telling two poses apart.
double extent_of(const MotionTask& task) {
  double extent = 0;
  for (const PrescribedPose& pose : task.poses)
    extent = std::max(extent, std::abs(pose.pose.origin - task.poses.front().pose.origin));
  return extent;
}

void check_repetitions(const MotionTask& task, std::vector<Error>& found) {
  const double extent = extent_of(task);
  for (std::size_t j = 1; j < task.poses.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (same_pose(task.poses[i].pose, task.poses[j].pose, extent)) {
        found.push_back({"repeated_pose", place_of(j),
                         fmt::format("poses[{}] and poses[{}] are the same; move one of them, or give a direction of "
                                     "travel at one pose instead of repeating it",
                                     i, j)});
        break;
      }
}

}  // namespace

std::vector<Error> mistakes_in(const MotionTask& task) {
  std::vector<Error> found;
  const std::size_t count = task.poses.size();
  if (count < 4)
    found.push_back(
        {"too_few_poses", "task.poses", fmt::format("{} poses were given and 4 are needed; add {}", count, 4 - count)});
  if (count > 4)
    found.push_back({"too_many_poses", "task.poses",
                     fmt::format("{} poses were given and 4 can be solved; remove {}", count, count - 4)});
  for (std::size_t i = 0; i < count; ++i)
    if (!task.poses[i].derivatives.empty())
      found.push_back({"not_available", place_of(i) + ".derivatives",
                       "directions of travel are not available in this version; give four finite poses"});
  check_numbers(task, found);
  if (found.empty()) check_repetitions(task, found);
  return found;
}

}  // namespace linkwright
