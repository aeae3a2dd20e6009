#include "linkwright/planar/path_task.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::string place_of_point(std::size_t point) { return fmt::format("task.points[{}]", point); }

double turned(const PathTask& task, std::size_t point) {
  return task.points[point].input.value_or(0) - task.points.front().input.value_or(0);
}

bool are_equal_angles(double a, double b) { return std::abs(wrap_signed(a - b)) < tolerance::repeated_input_angle; }

std::string count_words(const PathTask& task, int count) {
  const std::size_t points = task.points.size(), derivatives = static_cast<std::size_t>(count) - points;
  if (derivatives == 0) return fmt::format("{} {} given", points, points == 1 ? "point was" : "points were");
  return fmt::format("{} positions were given ({} point{} and {} derivative{}, each counting as one)", count, points,
                     points == 1 ? "" : "s", derivatives, derivatives == 1 ? "" : "s");
}

void check_count(const PathTask& task, std::vector<Error>& found) {
  constexpr int fewest = 4, most = 5;
  const int count = position_count(task.points), points = static_cast<int>(task.points.size());
  const bool plain = count == points;
  const Values values = {{"count", count},   {"points", points}, {"derivatives", count - points},
                         {"fewest", fewest}, {"most", most},     {"change", std::max(fewest - count, count - most)}};
  if (count < fewest)
    found.push_back(
        {plain ? "too_few_path_points" : "too_few_path_positions", "task.points",
         fmt::format("{} and {} or {} are needed; add {} (a direction of travel at a point, \"derivatives\", "
                     "counts as one more)",
                     count_words(task, count), fewest, most, fewest - count),
         values});
  if (count > most)
    found.push_back({plain ? "too_many_path_points" : "too_many_path_positions", "task.points",
                     fmt::format("{} and {} are the most that a four-bar can pass at given angles of its crank; "
                                 "remove {}",
                                 count_words(task, count), most, count - most),
                     values});
}

void check_count_for_pivots(const PathTask& task, std::vector<Error>& found) {
  const int count = position_count(task.points), wanted = task.pivots.count() == 1 ? 5 : 3;
  const int change = std::abs(wanted - count);
  if (count == wanted) return;
  const std::string_view advice = count < wanted ? "add" : "remove";
  const std::string_view code = wanted == 5 ? (count < 5 ? "too_few_points_for_pivot" : "too_many_points_for_pivot")
                                            : (count < 3 ? "too_few_points_for_pivots" : "too_many_points_for_pivots");
  found.push_back(
      {std::string(code),
       "task.points",
       fmt::format("{}, and {}; {} {} (a direction of travel at a point, \"derivatives\", counts as one more)",
                   count_words(task, count),
                   wanted == 5 ? "one ground pivot that is given goes with five"
                               : "two ground pivots that are given go with three",
                   advice, change),
       {{"count", count}, {"change", change}}});
}

double extent_of(const PathTask& task) {
  double extent = 0;
  for (const PathPoint& point : task.points)
    extent = std::max(extent, std::abs(point.point - task.points.front().point));
  return extent;
}

bool are_same_places(const PathTask& task, std::size_t i, std::size_t j) {
  return std::abs(task.points[i].point - task.points[j].point) <= tolerance::repeated_pose * extent_of(task);
}

void check_pivot(const PathTask& task, Point pivot, const std::string& place, std::vector<Error>& found) {
  check_number(pivot.real(), "x", place + "[0]", found);
  check_number(pivot.imag(), "y", place + "[1]", found);
  for (std::size_t i = 0; i < task.points.size() && found.empty(); ++i)
    if (std::abs(task.points[i].point - pivot) <= tolerance::repeated_pose * extent_of(task))
      found.push_back({"point_at_pivot",
                       place_of_point(i),
                       fmt::format("point {} lies at a ground pivot that is given: a link that reaches it there would "
                                   "turn freely; move one of both",
                                   i + 1),
                       {{"i", i + 1}}});
}

void check_pivots(const PathTask& task, std::vector<Error>& found) {
  const std::string place = "task.given.ground_pivots";
  if (task.pivots.input) check_pivot(task, *task.pivots.input, place + ".input", found);
  if (task.pivots.output) check_pivot(task, *task.pivots.output, place + ".output", found);
  if (task.pivots.count() == 2 && found.empty() &&
      std::abs(*task.pivots.input - *task.pivots.output) <= tolerance::repeated_pose * extent_of(task))
    found.push_back({"pivots_at_one_place", place,
                     "both ground pivots lie at one place: there is no ground link; move one of them"});
}

// A point without an angle of the crank is passed with some speed, and no angle tells the crank's.
void check_directions(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i)
    for (std::size_t m = 0; m < task.points[i].derivatives.size(); ++m) {
      const PathDerivative& derivative = task.points[i].derivatives[m];
      const std::string place = fmt::format("{}.derivatives[{}]", place_of_point(i), m);
      if (derivative.input)
        found.push_back({"rate_without_angle", place + ".input",
                         "the crank's rate goes with its angle, and this task gives none; leave \"input\" out"});
      if (m == 0 && derivative.point == Point{})
        found.push_back({"point_at_rest", place,
                         "the point would stand still here; give the direction in which it passes, of any length"});
    }
}

// An arm reaches a place in two ways.
void check_repetitions(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    std::size_t same = 0;
    for (std::size_t j = i + 1; j < task.points.size(); ++j) same += are_same_places(task, i, j);
    if (same > 1)
      return found.push_back(
          {"path_point_three_times",
           place_of_point(i),
           fmt::format("point {} is there three times, and a link comes there in two ways; leave one "
                       "out",
                       i + 1),
           {{"i", i + 1}}});
    if (i + 1 < task.points.size() && are_same_places(task, i, i + 1))
      return found.push_back({"path_point_again_at_once",
                              place_of_point(i + 1),
                              fmt::format("point {} is point {} again; leave it out, or give a direction of travel "
                                          "(\"derivatives\") instead",
                                          i + 2, i + 1),
                              {{"i", i + 1}, {"j", i + 2}}});
  }
}

void check_something_is_given(const PathTask& task, std::vector<Error>& found) {
  if (task.pivots.count() == 0)
    found.push_back({"path_leaves_too_much", "task.points",
                     "points alone leave too much open; give the angle of the crank at every point (\"input_deg\"), or "
                     "a ground pivot (\"given\": {\"ground_pivots\": {\"input\": [x, y]}}) with five points, or both "
                     "ground pivots with three"});
}

void check_nothing_else_is_given(const PathTask& task, std::vector<Error>& found) {
  if (task.pivots.count() > 0)
    found.push_back({"pivots_and_angles", "task.given",
                     "ground pivots are given together with angles of the crank, which leave no place for them; leave "
                     "one of both out"});
}

void check_timing_is_given(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i)
    if (!task.points[i].input)
      found.push_back({"untimed_point", place_of_point(i),
                       "this point has no angle of the crank; give every point its \"input_deg\", from any datum"});
}

void check_numbers(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const PathPoint& point = task.points[i];
    check_number(point.point.real(), "x", place_of_point(i) + ".x", found);
    check_number(point.point.imag(), "y", place_of_point(i) + ".y", found);
    if (point.input) check_angle(*point.input, "input_deg", place_of_point(i) + ".input_deg", found);
    for (std::size_t m = 0; m < point.derivatives.size(); ++m) {
      const std::string here = fmt::format("{}.derivatives[{}]", place_of_point(i), m);
      check_number(point.derivatives[m].point.real(), "x", here + ".x", found);
      check_number(point.derivatives[m].point.imag(), "y", here + ".y", found);
      if (point.derivatives[m].input) check_number(*point.derivatives[m].input, "input", here + ".input", found);
    }
  }
}

// 1, 4 → "1 and 4"; 2, 3, 4 → "2, 3 and 4".
std::string list_words(const std::vector<std::size_t>& points) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == points.size() ? " and " : ", ", points[i] + 1);
  return text;
}

Error repeated_point(const PathTask& task, std::size_t i, std::size_t j) {
  if (std::abs(turned(task, j) - turned(task, i)) > pi)
    return {"repeated_after_turn",
            place_of_point(j),
            fmt::format("point {} is point {} again after a full turn of the crank; leave it out: a crank that turns "
                        "fully comes back there by itself",
                        j + 1, i + 1),
            {{"i", i + 1}, {"j", j + 1}}};
  return {"repeated_point",
          place_of_point(j),
          fmt::format("points {} and {} are the same at the same angle of the crank; leave one out, or give a "
                      "direction of travel (\"derivatives\") at one of them instead",
                      i + 1, j + 1),
          {{"i", i + 1}, {"j", j + 1}}};
}

// Equal angles at different places: one crank, and the coupler in both of its assemblies.
void check_equal_angles(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    std::vector<std::size_t> equal = {i};
    bool are_whole_turns_apart = false;
    for (std::size_t j = i + 1; j < task.points.size(); ++j) {
      if (!are_equal_angles(turned(task, i), turned(task, j))) continue;
      if (are_same_places(task, i, j)) return found.push_back(repeated_point(task, i, j));
      are_whole_turns_apart = are_whole_turns_apart || std::abs(turned(task, i) - turned(task, j)) > pi;
      equal.push_back(j);
    }
    if (equal.size() == 1) continue;
    const std::string points = list_words(equal);
    return found.push_back({are_whole_turns_apart ? "equal_crank_angles_after_turn" : "equal_crank_angles",
                            place_of_point(equal[1]) + ".input_deg",
                            fmt::format("points {} have the same crank angle{}; a crank that stands takes the point to "
                                        "one place only, so change an angle",
                                        points, are_whole_turns_apart ? ", modulo 360" : ""),
                            {{"points", std::string_view(points)}}});
  }
}

// The first point at which the crank does not go on in the sense in which it went to the second; none: 0.
std::size_t where_it_turns_back(const PathTask& task) {
  for (std::size_t j = 2; j < task.points.size(); ++j)
    if ((turned(task, j) - turned(task, j - 1)) * turned(task, 1) <= 0) return j;
  return 0;
}

void check_span(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t j = 1; j < task.points.size(); ++j) {
    const double beyond = std::abs(turned(task, j)) - two_pi;
    if (beyond < 0) continue;
    const double angle = std::round(1e3 * degrees(std::fmod(beyond, two_pi))) / 1e3;
    std::size_t before = 1;
    while (before < j && std::fmod(beyond, two_pi) > std::abs(turned(task, before))) ++before;
    return found.push_back(
        {"more_than_a_turn",
         place_of_point(j) + ".input_deg",
         fmt::format("the crank passes point {} ({:g}° from point 1, modulo 360) before point {}; order the "
                     "points by crank angle, within one turn",
                     j + 1, angle, before + 1),
         {{"j", j + 1}, {"angle", angle}, {"i", before + 1}}});
  }
}

void check_sequence(const PathTask& task, std::vector<Error>& found) {
  const std::size_t back = where_it_turns_back(task);
  if (back == 0) return check_span(task, found);
  found.push_back({"crank_reverses",
                   place_of_point(back) + ".input_deg",
                   fmt::format("the crank would have to turn back after point {}; order the points by crank angle, all "
                               "rising or all falling within one turn",
                               back),
                   {{"i", back}}});
}

// The crank moves through every point as it does through the task.
void check_rates(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const auto& derivatives = task.points[i].derivatives;
    if (derivatives.empty() || !derivatives.front().input) continue;
    const std::string place = place_of_point(i) + ".derivatives[0].input";
    const double rate = *derivatives.front().input;
    if (std::abs(rate) < tolerance::smallest_direction)
      found.push_back({"crank_at_rest", place,
                       "the crank stands still in this derivative, and it is to move through the point; give it a "
                       "rate, or leave \"input\" out"});
    else if (task.points.size() > 1 && rate * crank_sense(task) < 0)
      found.push_back({"crank_against_sense", place,
                       "in this derivative the crank turns against the sense in which it passes the points; turn the "
                       "derivatives of odd order round"});
  }
}

}  // namespace

double crank_sense(const PathTask& task) {
  double sense = 1;
  if (task.points.size() > 1)
    sense = turned(task, 1);
  else if (!task.points.front().derivatives.empty())
    sense = task.points.front().derivatives.front().input.value_or(1);
  return sense < 0 ? -1 : 1;
}

static std::vector<Error> mistakes_in_timed(const PathTask& task) {
  std::vector<Error> found;
  check_count(task, found);
  check_timing_is_given(task, found);
  check_numbers(task, found);
  if (found.empty()) check_nothing_else_is_given(task, found);
  if (found.empty()) check_equal_angles(task, found);
  if (found.empty()) check_sequence(task, found);
  if (found.empty()) check_rates(task, found);
  return found;
}

static std::vector<Error> mistakes_in_untimed(const PathTask& task) {
  std::vector<Error> found;
  check_numbers(task, found);
  if (found.empty()) check_something_is_given(task, found);
  if (found.empty()) check_count_for_pivots(task, found);
  if (found.empty()) check_pivots(task, found);
  if (found.empty()) check_directions(task, found);
  if (found.empty()) check_repetitions(task, found);
  return found;
}

std::vector<Error> mistakes_in(const PathTask& task) {
  const bool has_nothing = task.points.empty() && task.pivots.count() == 0;
  return task.is_timed() || has_nothing ? mistakes_in_timed(task) : mistakes_in_untimed(task);
}

std::vector<PrescribedPose> crank_poses(const PathTask& task) {
  std::vector<PrescribedPose> poses;
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    PrescribedPose pose{{task.points[i].point, turned(task, i)}, {}};
    for (const PathDerivative& d : task.points[i].derivatives)
      pose.derivatives.push_back({d.point, d.input.value_or(pose.derivatives.empty() ? crank_sense(task) : 0)});
    poses.push_back(std::move(pose));
  }
  return poses;
}

}  // namespace linkwright
