#include "near_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::string place_of(const MotionTask& task, std::size_t index, bool is_near = true) {
  const std::vector<TaskPlace> places = places_of(task);
  const auto is_it = [&](const TaskPlace& place) { return place.is_near == is_near && place.index == index; };
  return fmt::format("task.poses[{}]", std::find_if(places.begin(), places.end(), is_it) - places.begin());
}

void check_turning_length(const MotionTask& task, std::vector<Error>& found) {
  if (!task.turning_length) return;
  if (task.near.empty())
    found.push_back({"unneeded_turning_length", "task.turning_length",
                     "a turning length weighs errors of near poses, and none is near; leave it out, or mark poses "
                     "\"near\": true"});
  else if (!(*task.turning_length > 0 && *task.turning_length <= largest_coordinate))
    found.push_back({"near_turning_length", "task.turning_length",
                     "a turning length is a length above 0; leave it out to have the characteristic length"});
}

void check_one(const MotionTask& task, std::size_t k, std::vector<Error>& found) {
  const NearPose& near = task.near[k];
  const auto wrong = [](const std::optional<double>& given, double most) {
    return given && !(*given > 0 && *given <= most);
  };
  const bool is_position = near.tolerance && wrong(near.tolerance->position, largest_coordinate);
  const bool is_angle = near.tolerance && wrong(near.tolerance->angle, largest_coordinate);
  const bool is_weight = near.weight && !(*near.weight >= 0 && *near.weight <= largest_coordinate);
  const bool is_empty = near.tolerance && !near.tolerance->position && !near.tolerance->angle;
  const std::string place = place_of(task, k);
  check_number(near.pose.origin.real(), "x", place + ".x", found);
  check_number(near.pose.origin.imag(), "y", place + ".y", found);
  check_angle(near.pose.angle, "theta_deg", place + ".theta_deg", found);
  if (is_position)
    found.push_back({"near_tolerance", place + ".tolerance.position",
                     "a tolerance is a length above 0; leave it out where there is none"});
  if (is_angle)
    found.push_back({"near_angle_tolerance", place + ".tolerance.angle_deg",
                     "a tolerance is an angle above 0; leave it out where there is none"});
  if (is_empty)
    found.push_back({"near_tolerance_empty", place + ".tolerance",
                     "a tolerance has a \"position\", an \"angle_deg\", or both; give one, or leave it out"});
  if (is_weight) found.push_back({"near_weight", place + ".weight", "a weight is a number of 0 or more"});
}

void check_together(const MotionTask& task, std::vector<Error>& found) {
  if (task.near.size() > MotionTask::most_near)
    found.push_back(
        {"too_many_near_poses",
         "task.poses",
         fmt::format("{} poses are near, and {} are the most; leave some out", task.near.size(), MotionTask::most_near),
         {{"count", task.near.size()}, {"most", MotionTask::most_near}}});
  const bool none_counts = std::none_of(task.near.begin(), task.near.end(),
                                        [](const NearPose& near) { return near.weight.value_or(1) > 0; });
  if (none_counts)
    found.push_back(
        {"no_near_weight", "task.poses", "all near poses have weight 0, so that any linkage would do; give some"});
  if (task.relaxed && position_count(task.poses) == 5)
    found.push_back({"near_with_freed_pose", "task.freed_pose",
                     "a freed pose goes with five exact ones; leave it out and mark that pose \"near\": true"});
  if (!task.is_fitted()) return;
  for (std::size_t i = 0; i < task.poses.size(); ++i)
    if (!task.poses[i].derivatives.empty())
      found.push_back({"near_with_derivatives", place_of(task, i, false) + ".derivatives",
                       "directions of travel go with four or five exact positions; leave them out, or make more "
                       "positions exact"});
}

// Distances in the drawing's size tell two poses apart.
void check_enough(const MotionTask& task, std::vector<Error>& found) {
  if (!task.is_fitted()) return;
  std::vector<Pose> all, different;
  for (const PrescribedPose& pose : task.poses) all.push_back(pose.pose);
  for (const NearPose& near : task.near) all.push_back(near.pose);
  double extent = 0;
  for (const Pose& pose : all) extent = std::max(extent, std::abs(pose.origin - all.front().origin));
  const auto is_same = [&](const Pose& a, const Pose& b) {
    return std::abs(a.origin - b.origin) <= tolerance::repeated_pose * extent &&
           std::abs(direction(a.angle) - direction(b.angle)) <= tolerance::repeated_pose;
  };
  constexpr std::size_t fewest = 3;
  for (const Pose& pose : all) {
    if (different.size() == fewest) return;
    if (std::none_of(different.begin(), different.end(), [&](const Pose& known) { return is_same(known, pose); }))
      different.push_back(pose);
  }
  if (different.size() < fewest)
    found.push_back({"too_few_near_poses",
                     "task.poses",
                     fmt::format("{} different poses were given, and a linkage is fitted to three or more; add poses",
                                 different.size()),
                     {{"count", different.size()}}});
}

}  // namespace

std::vector<Error> mistakes_in_near(const MotionTask& task) {
  std::vector<Error> found;
  check_turning_length(task, found);
  if (task.near.empty()) return found;
  for (std::size_t k = 0; k < task.near.size() && found.empty(); ++k) check_one(task, k, found);
  check_together(task, found);
  if (found.empty()) check_enough(task, found);
  return found;
}

}  // namespace linkwright
