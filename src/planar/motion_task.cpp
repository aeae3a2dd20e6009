#include "linkwright/planar/motion_task.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"
#include "planar/line_check.hpp"
#include "planar/near_check.hpp"

namespace linkwright {
namespace {

std::string place_of_pose(std::size_t pose) { return fmt::format("task.poses[{}]", pose); }

// Where an exact pose stands among all poses of the task.
std::size_t listed_at(const MotionTask& task, std::size_t exact) {
  const auto comes_before = [&](const NearPose& near) { return near.after <= exact; };
  return exact + static_cast<std::size_t>(std::count_if(task.near.begin(), task.near.end(), comes_before));
}

bool is_zero(const PoseDerivative& d) {
  return std::max({std::abs(d.origin.real()), std::abs(d.origin.imag()), std::abs(d.angle)}) <
         tolerance::smallest_direction;
}

void check_derivatives(const std::vector<PoseDerivative>& derivatives, const std::string& place,
                       std::vector<Error>& found) {
  for (std::size_t m = 0; m < derivatives.size(); ++m) {
    const std::string here = fmt::format("{}[{}]", place, m);
    check_number(derivatives[m].origin.real(), "x", here + ".x", found);
    check_number(derivatives[m].origin.imag(), "y", here + ".y", found);
    check_number(derivatives[m].angle, "theta", here + ".theta", found);
  }
  if (!derivatives.empty() && is_zero(derivatives.front()))
    found.push_back({"zero_derivative", place + "[0]",
                     "the first derivative is zero and gives no direction of travel; give one in which the body moves "
                     "or turns there, of any length, or leave derivatives out"});
}

void check_pose(const Pose& pose, const std::string& place, std::vector<Error>& found) {
  check_number(pose.origin.real(), "x", place + ".x", found);
  check_number(pose.origin.imag(), "y", place + ".y", found);
  check_angle(pose.angle, "theta_deg", place + ".theta_deg", found);
}

void check_numbers(const MotionTask& task, std::vector<Error>& found) {
  check_points(task.points, found);
  for (std::size_t i = 0; i < task.poses.size(); ++i) {
    const std::string place = place_of_pose(listed_at(task, i));
    if (task.points.empty()) check_pose(task.poses[i].pose, place, found);
    check_derivatives(task.poses[i].derivatives, place + ".derivatives", found);
  }
}

std::string short_pattern(const MotionTask& task) {
  constexpr std::size_t most = 12;
  const std::string text = pattern(task.poses);
  return text.size() <= most ? text : text.substr(0, most) + "…";
}

// "5 positions were given (PPP-P-P: 3 poses and 2 derivatives)"; without derivatives the poses are the positions.
std::string count_words(const MotionTask& task, int count) {
  const std::size_t poses = task.poses.size(), derivatives = static_cast<std::size_t>(count) - poses;
  if (derivatives == 0) return fmt::format("{} {} given", poses, poses == 1 ? "pose was" : "poses were");
  return fmt::format("{} positions were given ({}: {} pose{} and {} derivative{}, each counting as one)", count,
                     short_pattern(task), poses, poses == 1 ? "" : "s", derivatives, derivatives == 1 ? "" : "s");
}

void check_count(const MotionTask& task, std::vector<Error>& found) {
  constexpr int most = 5;
  const int fewest = task.near.empty() ? 3 : 0;  // how few near ones there may be, is asked elsewhere
  const int count = position_count(task.poses), poses = static_cast<int>(task.poses.size());
  const bool plain = count == poses;
  const Values values = {{"count", count},
                         {"pattern", short_pattern(task)},
                         {"poses", poses},
                         {"derivatives", count - poses},
                         {"fewest", fewest},
                         {"most", most},
                         {"change", std::max(fewest - count, count - most)}};
  if (count < fewest)
    found.push_back(
        {plain ? "too_few_poses" : "too_few_positions", "task.poses",
         fmt::format("{} and {} to {} are needed; add {} (a direction of travel at a pose, \"derivatives\", counts "
                     "as one more)",
                     count_words(task, count), fewest, most, fewest - count),
         values});
  if (count > most)
    found.push_back({plain ? "too_many_poses" : "too_many_positions", "task.poses",
                     fmt::format("{} and {} are the most that a four-bar can pass exactly; remove {}, or mark some "
                                 "poses \"near\": true",
                                 count_words(task, count), most, count - most),
                     values});
}

bool has_derivatives(const MotionTask& task) {
  return std::any_of(task.poses.begin(), task.poses.end(),
                     [](const PrescribedPose& pose) { return !pose.derivatives.empty(); });
}

void check_given(const MotionTask& task, std::vector<Error>& found) {
  const bool three = position_count(task.poses) == 3;
  if (three && !task.given && task.near.empty())
    found.push_back(
        {"missing_given", "task.given",
         "three positions leave four numbers free; give the grounded links' lengths {\"side_lengths\": [input, "
         "output]}, the angle between them {\"side_angle_deg\": …} or the instant centre "
         "{\"instant_center\": [x, y]}, both ground pivots {\"ground_pivots\": {\"input\": [x, y], \"output\": "
         "[x, y]}} or moving pivots, one pivot {\"input_ground_pivot\": [x, y]}, a line of pivots "
         "{\"ground_pivot_on\": {\"point\": [x, y], \"direction_deg\": …}}, or add a fourth position"});
  if (!task.given) return;
  if (!three)
    found.push_back({"unneeded_given",
                     "task.given",
                     fmt::format("\"given\" belongs to three positions, and {} are given; leave it out",
                                 position_count(task.poses)),
                     {{"count", position_count(task.poses)}}});
  const std::vector<Error> of_given = mistakes_in(*task.given);
  found.insert(found.end(), of_given.begin(), of_given.end());
  if (three && std::holds_alternative<InstantCenter>(*task.given) && has_derivatives(task))
    found.push_back({"unneeded_center", "task.given.instant_center",
                     "an instant centre goes with three poses without derivatives; a direction of travel in position 1 "
                     "says the same, so leave one of the two out"});
}

void check_pivots_on(const MotionTask& task, std::vector<Error>& found) {
  if (task.pivots_on.empty()) return;
  const int count = position_count(task.poses);
  if (count != 4)
    found.push_back(
        {"unneeded_pivot_on",
         "task.pivot_on",
         fmt::format("\"pivot_on\" belongs to four positions, and {} are given; leave it out (three positions have "
                     "\"ground_pivot_on\" and \"moving_pivot_on\" in \"given\")",
                     count),
         {{"count", count}}});
  for (std::size_t i = 0; i < task.pivots_on.size(); ++i) {
    const std::string place = fmt::format("task.pivot_on[{}]", i);
    check_line(task.pivots_on[i].line, place + ".line", found);
    for (std::size_t j = 0; j < i; ++j)
      if (task.pivots_on[j].side == task.pivots_on[i].side)
        found.push_back({"two_pivots_on", place,
                         "there is a line for a pivot of this link already, and few dyads satisfy it; keep one"});
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
        const std::size_t first = listed_at(task, i), second = listed_at(task, j);
        found.push_back({"repeated_pose",
                         place_of_pose(second),
                         fmt::format("poses[{}] and poses[{}] are the same; move one of them, or give a direction of "
                                     "travel at one pose instead of repeating it",
                                     first, second),
                         {{"i", first}, {"j", second}}});
        break;
      }
}

void check_freed(const MotionTask& task, std::vector<Error>& found) {
  if (!task.relaxed) return;
  if (*task.relaxed >= task.poses.size())
    found.push_back({"no_such_pose",
                     "task.freed_pose",
                     fmt::format("there are {} poses; the first is 1", task.poses.size()),
                     {{"count", task.poses.size()}}});
  else if (position_count(task.poses) != 5 || !task.poses[*task.relaxed].derivatives.empty())
    found.push_back({"unneeded_freed_pose", "task.freed_pose",
                     "a pose is freed of five positions, and one without derivatives; leave \"freed_pose\" out"});
}

}  // namespace

bool MotionTask::is_fitted() const { return !near.empty() && position_count(poses) < (given ? 3 : 4); }

std::vector<TaskPlace> places_of(const MotionTask& task) {
  std::vector<TaskPlace> places;
  std::size_t next = 0;
  for (std::size_t exact = 0; exact <= task.poses.size(); ++exact) {
    while (next < task.near.size() && (task.near[next].after <= exact || exact == task.poses.size()))
      places.push_back({true, next++});
    if (exact < task.poses.size()) places.push_back({false, exact});
  }
  return places;
}

std::vector<PrescribedPose> all_poses(const MotionTask& task) {
  std::vector<PrescribedPose> all;
  for (const TaskPlace& place : places_of(task))
    all.push_back(place.is_near ? PrescribedPose{task.near[place.index].pose, {}} : task.poses[place.index]);
  return all;
}

std::vector<Error> mistakes_in(const MotionTask& task) {
  std::vector<Error> found;
  check_count(task, found);
  check_numbers(task, found);
  check_given(task, found);
  check_pivots_on(task, found);
  check_freed(task, found);
  if (!task.near.empty() || task.turning_length)
    for (Error& mistake : mistakes_in_near(task)) found.push_back(std::move(mistake));
  if (found.empty()) check_repetitions(task, found);
  return found;
}

}  // namespace linkwright
