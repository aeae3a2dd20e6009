#include "linkwright/spherical/spherical_motion_task.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr double largest_rate = 1e9;
constexpr std::array<std::string_view, 4> derivative_names = {"angular_velocity", "angular_acceleration",
                                                              "angular_jerk", "angular_snap"};

void check_derivatives(const SphericalMotionTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.orientations.size(); ++i) {
    const auto& derivatives = task.orientations[i].derivatives;
    for (std::size_t m = 0; m < derivatives.size(); ++m) {
      const std::string place =
          fmt::format("task.orientations[{}].{}", i, derivative_names[std::min(m, derivative_names.size() - 1)]);
      if (!(norm(derivatives[m]) <= largest_rate))
        found.push_back({"rate_range",
                         place,
                         fmt::format("its three numbers must be between −{0} and {0}", limit_text(largest_rate)),
                         {{"most", limit_text(largest_rate)}}});
      else if (m == 0 && norm(derivatives[m]) < tolerance::smallest_direction)
        found.push_back({"zero_angular_velocity", place,
                         "the angular velocity is zero and gives no direction of travel; give one of any length, or "
                         "leave the derivatives out"});
    }
  }
}

void check_orientation_count(const SphericalMotionTask& task, std::vector<Error>& found) {
  constexpr int fewest = 4, most = 5;
  const int count = position_count(task.orientations);
  const Values values = {{"count", count}, {"missing", fewest - count}, {"excess", count - most}};
  if (count < fewest && !(count == 3 && task.given))
    found.push_back({"too_few_orientations", "task.orientations",
                     fmt::format("{} {} given and four or five are needed; add {} (an angular velocity counts as one "
                                 "more), or give three orientations and two axes, \"given\": {{\"fixed_axes\": "
                                 "[…, …]}} or {{\"moving_axes\": […, …]}}",
                                 count, count == 1 ? "orientation is" : "orientations are", fewest - count),
                     values});
  if (count > most)
    found.push_back({"too_many_orientations", "task.orientations",
                     fmt::format("{} positions are given and five are the most that a spherical four-bar can pass "
                                 "exactly; remove {}",
                                 count, count - most),
                     values});
}

void check_given_axes(const SphericalMotionTask& task, std::vector<Error>& found) {
  if (!task.given) return;
  const int count = position_count(task.orientations);
  const std::string place =
      task.given->kind == GivenAxes::Kind::fixed ? "task.given.fixed_axes" : "task.given.moving_axes";
  if (count > 3)
    found.push_back({"unneeded_axes",
                     "task.given",
                     fmt::format("\"given\" belongs to three orientations, and {} are given; leave it out", count),
                     {{"count", count}}});
  if (count == 3 && task.orientations.size() != 3)
    found.push_back({"derivatives_with_axes", "task.orientations",
                     "given axes go with three orientations without derivatives; add a fourth position and leave "
                     "\"given\" out, or leave the derivatives out"});
  for (std::size_t i = 0; i < 2; ++i)
    if (!is_finite(task.given->axes[i]) || !(norm(task.given->axes[i]) > 0))
      found.push_back(
          {"no_axis", fmt::format("{}[{}]", place, i), "this axis has no direction; give one of any length"});
  if (found.empty() &&
      norm(cross(normalized(task.given->axes[0]), normalized(task.given->axes[1]))) < tolerance::parallel_lines)
    found.push_back({"same_axes", place, "both axes are the same; a four-bar needs two"});
}

}  // namespace

std::vector<Error> mistakes_in(const SphericalMotionTask& task) {
  std::vector<Error> found;
  check_orientation_count(task, found);
  check_derivatives(task, found);
  check_given_axes(task, found);
  return found;
}

}  // namespace linkwright
