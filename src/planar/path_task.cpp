#include "linkwright/planar/path_task.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/six_bar_task.hpp"
#include "nearest_path.hpp"
#include "path_points.hpp"

namespace linkwright {
namespace {

bool is_angled(const PathPoint& point) { return !point.is_plain(); }
bool has_crank_angle(const PathPoint& point) { return point.input.has_value(); }

template <class Is>
std::vector<std::size_t> points_that(const PathTask& task, Is is) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < task.points.size(); ++i)
    if (is(task.points[i])) indices.push_back(i);
  return indices;
}
std::vector<std::size_t> timed_points(const PathTask& task) { return points_that(task, has_crank_angle); }

// From the first point at which the crank's angle is given on.
double turned(const PathTask& task, std::size_t point) {
  const auto first = std::find_if(task.points.begin(), task.points.end(), has_crank_angle);
  return first == task.points.end() ? 0 : *task.points[point].input - *first->input;
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

void check_count_for_pivot(const PathTask& task, std::vector<Error>& found) {
  constexpr int wanted = 5;
  const int count = position_count(task.points), change = std::abs(wanted - count);
  if (count == wanted) return;
  found.push_back({count < wanted ? "too_few_points_for_pivot" : "too_many_points_for_pivot",
                   "task.points",
                   fmt::format("{}, and one ground pivot, given or searched for, goes with five; {} {} (a direction of "
                               "travel at a point, \"derivatives\", counts as one more)",
                               count_words(task, count), count < wanted ? "add" : "remove", change),
                   {{"count", count}, {"change", change}}});
}

void check_count_for_pivots(const PathTask& task, std::vector<Error>& found) {
  const int count = position_count(task.points);
  if (task.pivots.count() < 2) return check_count_for_pivot(task, found);
  if (count == 3 || count == 5) return;
  const int change = count < 3 ? 3 - count : count == 4 ? 1 : count - 5;
  found.push_back(
      {count < 3    ? "too_few_points_for_pivots"
       : count == 4 ? "four_points_for_pivots"
                    : "too_many_points_for_pivots",
       "task.points",
       fmt::format("{}, and two ground pivots that are given go with three or with five; {} {} (a direction "
                   "of travel at a point, \"derivatives\", counts as one more)",
                   count_words(task, count),
                   count < 3    ? "add"
                   : count == 4 ? "add or remove"
                                : "remove",
                   change),
       {{"count", count}, {"change", change}}});
}

bool are_same_places(const PathTask& task, std::size_t i, std::size_t j) {
  return std::abs(task.points[i].point - task.points[j].point) <= tolerance::repeated_pose * extent_of(task);
}

// A point without an angle of the crank is passed with some speed, and no angle tells the crank's.
void check_directions(const PathTask& task, std::vector<Error>& found) {
  for (const std::size_t i : points_that(task, [](const PathPoint& point) { return !point.input; }))
    for (std::size_t m = 0; m < task.points[i].derivatives.size(); ++m) {
      const PathDerivative& derivative = task.points[i].derivatives[m];
      const std::string place = fmt::format("{}.derivatives[{}]", place_of_path_point(i), m);
      if (derivative.input)
        found.push_back({"rate_without_angle", place + ".input",
                         "the crank's rate goes with its angle, and this point has none; leave \"input\" out"});
      if (m == 0 && derivative.point == Point{} && derivative.angle.value_or(0) == 0)
        found.push_back({"point_at_rest", place,
                         "the point would stand still here; give the direction in which it passes, of any length"});
    }
}

// An arm reaches a place in two ways.
void check_repetitions(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    std::size_t same = 0;
    if (!task.points[i].is_plain()) continue;
    for (std::size_t j = i + 1; j < task.points.size(); ++j)
      same += task.points[j].is_plain() && are_same_places(task, i, j);
    if (same > 1)
      return found.push_back(
          {"path_point_three_times",
           place_of_path_point(i),
           fmt::format("point {} is there three times, and a link comes there in two ways; leave one "
                       "out",
                       i + 1),
           {{"i", i + 1}}});
    if (i + 1 < task.points.size() && are_same_places(task, i, i + 1))
      return found.push_back({"path_point_again_at_once",
                              place_of_path_point(i + 1),
                              fmt::format("point {} is point {} again; leave it out, or give a direction of travel "
                                          "(\"derivatives\") instead",
                                          i + 2, i + 1),
                              {{"i", i + 1}, {"j", i + 2}}});
  }
}

void check_something_is_given(const PathTask& task, std::vector<Error>& found) {
  if (task.pivots.count() == 0 && !task.box)
    found.push_back({"path_leaves_too_much", "task.points",
                     "points alone leave too much open; give the angle of the crank at every point (\"input_deg\"), or "
                     "a ground pivot (\"given\": {\"ground_pivots\": {\"input\": [x, y]}}) with five points, or both "
                     "ground pivots with three or five, or a box in which the pivot is searched for (\"box\" of the "
                     "options) with five points"});
}

void check_box(const PathTask& task, std::vector<Error>& found) {
  if (!task.box) return;
  if (task.pivots.count() > 0 || task.angled_count() > 0)
    return found.push_back({"box_of_path", "options.box",
                            "a ground pivot is searched for in a box where five points are given and nothing else; "
                            "leave the box out, or the pivots and the angles"});
  for (Error& mistake : mistakes_in_search_box(*task.box)) found.push_back(std::move(mistake));
}

// Of one link alone, and not of all points of the coupler: that is a motion task.
void check_kinds_of_angles(const PathTask& task, std::vector<Error>& found) {
  const auto posed = points_that(task, [](const PathPoint& point) { return point.angle.has_value(); });
  const auto with_both = points_that(task, [](const PathPoint& point) { return point.angle && point.input; });
  const auto timed = timed_points(task);
  if (!with_both.empty())
    found.push_back(
        {"path_point_with_both_angles", place_of_path_point(with_both.front()),
         "this point has an angle of the crank and one of the coupler, more than a four-bar can keep; leave "
         "one out"});
  else if (!posed.empty() && !timed.empty())
    found.push_back({"path_angles_of_both_links", place_of_path_point(std::max(posed.front(), timed.front())),
                     "some points have an angle of the crank (\"input_deg\"), others one of the coupler "
                     "(\"theta_deg\"); give those of one link"});
  else if (!posed.empty() && posed.size() == task.points.size())
    found.push_back({"path_of_poses", "task.points",
                     "the coupler's angle is given at every point: that is a motion task, so set \"kind\" to "
                     "\"motion\" and name the points \"poses\""});
}

// Between two given pivots five places are told apart by the four-bars' equations only where they differ.
void check_places_between_pivots(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    if (!task.points[i].derivatives.empty())
      return found.push_back({"derivatives_between_pivots", place_of_path_point(i) + ".derivatives",
                              "two ground pivots that are given go with five points without derivatives; leave them "
                              "out, or one of the pivots"});
    for (std::size_t j = i + 1; j < task.points.size(); ++j)
      if (are_same_places(task, i, j))
        return found.push_back(
            {"repeated_point_between_pivots",
             place_of_path_point(j),
             fmt::format("points {} and {} are at one place, and two ground pivots that are given go "
                         "with five different ones; move a point, or leave a pivot out",
                         i + 1, j + 1),
             {{"i", i + 1}, {"j", j + 1}}});
  }
}

// Some with an angle, others without.
void check_count_of_mixed(const PathTask& task, std::vector<Error>& found) {
  const int angled = task.angled_count(), plain = position_count(task.points) - angled;
  if (task.pivots.count() > 0)
    found.push_back({"pivots_and_angles", "task.given",
                     "ground pivots are given together with angles at some points, which leave no place for them; "
                     "leave one of both out"});
  else if (!(angled == 3 && plain == 2) && !(angled == 4 && plain == 1))
    found.push_back(
        {"mixed_path_count",
         "task.points",
         fmt::format("{} with an angle of the crank or the coupler and {} without were given; three go with "
                     "two, and four with one (a derivative counts as one more position)",
                     angled == 1 ? "1 position" : fmt::format("{} positions", angled), plain),
         {{"angled", angled}, {"plain", plain}}});
}

void check_count_for_timed_pivots(const PathTask& task, std::vector<Error>& found) {
  const int count = position_count(task.points);
  if (count != 3)
    found.push_back({"timed_count_for_pivots",
                     "task.points",
                     fmt::format("{}, and with angles of the crank at all of them ground pivots that are given go with "
                                 "three",
                                 count_words(task, count)),
                     {{"count", count}}});
}

// The same pose twice says nothing the second time.
void check_same_poses(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i)
    for (std::size_t j = i + 1; j < task.points.size(); ++j) {
      const auto &a = task.points[i].angle, &b = task.points[j].angle;
      if (a && b && are_same_places(task, i, j) && are_equal_angles(*a, *b))
        return found.push_back({"repeated_path_pose",
                                place_of_path_point(j),
                                fmt::format("point {} is point {} again, with the same angle of the coupler; leave one "
                                            "out, or give a direction of travel (\"derivatives\") instead",
                                            j + 1, i + 1),
                                {{"i", i + 1}, {"j", j + 1}}});
    }
}

void check_coupler_rates(const PathTask& task, std::size_t i, std::vector<Error>& found) {
  const PathPoint& point = task.points[i];
  for (std::size_t m = 0; m < point.derivatives.size(); ++m) {
    const PathDerivative& derivative = point.derivatives[m];
    const std::string place = fmt::format("{}.derivatives[{}]", place_of_path_point(i), m);
    if (derivative.angle.has_value() != point.angle.has_value())
      found.push_back(point.angle ? Error{"coupler_rate_missing", place,
                                          "the coupler's angle is given at this point, so its derivative is needed, "
                                          "too: \"theta\", radians per power of the parameter"}
                                  : Error{"rate_without_coupler_angle", place + ".theta",
                                          "the coupler's rate goes with its angle (\"theta_deg\"), and this point has "
                                          "none; leave \"theta\" out"});
  }
}

void check_numbers(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const PathPoint& point = task.points[i];
    check_number(point.point.real(), "x", place_of_path_point(i) + ".x", found);
    check_number(point.point.imag(), "y", place_of_path_point(i) + ".y", found);
    if (point.input) check_angle(*point.input, "input_deg", place_of_path_point(i) + ".input_deg", found);
    if (point.angle) check_angle(*point.angle, "theta", place_of_path_point(i) + ".theta_deg", found);
    for (std::size_t m = 0; m < point.derivatives.size(); ++m) {
      const std::string here = fmt::format("{}.derivatives[{}]", place_of_path_point(i), m);
      check_number(point.derivatives[m].point.real(), "x", here + ".x", found);
      check_number(point.derivatives[m].point.imag(), "y", here + ".y", found);
      if (point.derivatives[m].input) check_number(*point.derivatives[m].input, "input", here + ".input", found);
      if (point.derivatives[m].angle) check_number(*point.derivatives[m].angle, "theta", here + ".theta", found);
    }
    check_coupler_rates(task, i, found);
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
            place_of_path_point(j),
            fmt::format("point {} is point {} again after a full turn of the crank; leave it out: a crank that turns "
                        "fully comes back there by itself",
                        j + 1, i + 1),
            {{"i", i + 1}, {"j", j + 1}}};
  return {"repeated_point",
          place_of_path_point(j),
          fmt::format("points {} and {} are the same at the same angle of the crank; leave one out, or give a "
                      "direction of travel (\"derivatives\") at one of them instead",
                      i + 1, j + 1),
          {{"i", i + 1}, {"j", j + 1}}};
}

// Equal angles at different places: one crank, and the coupler in both of its assemblies.
void check_equal_angles(const PathTask& task, std::vector<Error>& found) {
  const std::vector<std::size_t> timed = timed_points(task);
  for (std::size_t a = 0; a < timed.size(); ++a) {
    const std::size_t i = timed[a];
    std::vector<std::size_t> equal = {i};
    bool are_whole_turns_apart = false;
    for (std::size_t b = a + 1; b < timed.size(); ++b) {
      const std::size_t j = timed[b];
      if (!are_equal_angles(turned(task, i), turned(task, j))) continue;
      if (are_same_places(task, i, j)) return found.push_back(repeated_point(task, i, j));
      are_whole_turns_apart = are_whole_turns_apart || std::abs(turned(task, i) - turned(task, j)) > pi;
      equal.push_back(j);
    }
    if (equal.size() == 1) continue;
    const std::string points = list_words(equal);
    return found.push_back({are_whole_turns_apart ? "equal_crank_angles_after_turn" : "equal_crank_angles",
                            place_of_path_point(equal[1]) + ".input_deg",
                            fmt::format("points {} have the same crank angle{}; a crank that stands takes the point to "
                                        "one place only, so change an angle",
                                        points, are_whole_turns_apart ? ", modulo 360" : ""),
                            {{"points", std::string_view(points)}}});
  }
}

// The first point at which the crank does not go on in the sense in which it began, and the one before; none: 0, 0.
std::array<std::size_t, 2> where_it_turns_back(const PathTask& task, const std::vector<std::size_t>& timed) {
  for (std::size_t k = 2; k < timed.size(); ++k)
    if ((turned(task, timed[k]) - turned(task, timed[k - 1])) * turned(task, timed[1]) <= 0)
      return {timed[k], timed[k - 1]};
  return {0, 0};
}

void check_span(const PathTask& task, const std::vector<std::size_t>& timed, std::vector<Error>& found) {
  for (std::size_t k = 1; k < timed.size(); ++k) {
    const std::size_t j = timed[k];
    const double beyond = std::abs(turned(task, j)) - two_pi;
    if (beyond < 0) continue;
    const double angle = std::round(1e3 * degrees(std::fmod(beyond, two_pi))) / 1e3;
    std::size_t before = 1;
    while (before < k && std::fmod(beyond, two_pi) > std::abs(turned(task, timed[before]))) ++before;
    return found.push_back(
        {"more_than_a_turn",
         place_of_path_point(j) + ".input_deg",
         fmt::format("the crank passes point {} ({:g}° from point {}, modulo 360) before point {}; order the "
                     "points by crank angle, within one turn",
                     j + 1, angle, timed.front() + 1, timed[before] + 1),
         {{"j", j + 1}, {"angle", angle}, {"from", timed.front() + 1}, {"i", timed[before] + 1}}});
  }
}

void check_sequence(const PathTask& task, std::vector<Error>& found) {
  const std::vector<std::size_t> timed = timed_points(task);
  const auto [back, before] = where_it_turns_back(task, timed);
  if (back == 0) return check_span(task, timed, found);
  found.push_back({"crank_reverses",
                   place_of_path_point(back) + ".input_deg",
                   fmt::format("the crank would have to turn back after point {}; order the points by crank angle, all "
                               "rising or all falling within one turn",
                               before + 1),
                   {{"i", before + 1}}});
}

// The crank moves through every point as it does through the task.
void check_rates(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const auto& derivatives = task.points[i].derivatives;
    if (!task.points[i].input || derivatives.empty() || !derivatives.front().input) continue;
    const std::string place = place_of_path_point(i) + ".derivatives[0].input";
    const double rate = *derivatives.front().input;
    if (std::abs(rate) < tolerance::smallest_direction)
      found.push_back({"crank_at_rest", place,
                       "the crank stands still in this derivative, and it is to move through the point; give it a "
                       "rate, or leave \"input\" out"});
    else if (timed_points(task).size() > 1 && rate * crank_sense(task) < 0)
      found.push_back({"crank_against_sense", place,
                       "in this derivative the crank turns against the sense in which it passes the points; turn the "
                       "derivatives of odd order round"});
  }
}

}  // namespace

std::string_view name(PathTiming timing) {
  constexpr std::array<std::string_view, 3> names = {"none", "some", "all"};
  return names[static_cast<std::size_t>(timing)];
}

PathTiming PathTask::timing() const {
  const std::size_t timed = timed_points(*this).size();
  return timed == 0 ? PathTiming::none : timed == points.size() ? PathTiming::all : PathTiming::some;
}

int PathTask::angled_count() const {
  int count = 0;
  for (const std::size_t i : points_that(*this, is_angled)) count += points[i].multiplicity();
  return count;
}

PathForm PathTask::form() const {
  if (is_approximate()) return PathForm::nearest;
  const int angled = angled_count(), plain = position_count(points) - angled;
  if (pivots.count() == 2 && (angled > 0 || plain != 3)) return PathForm::few;
  if (angled == 0) return PathForm::arms;
  if (pivots.count() == 1) return PathForm::other_pivot;
  if (plain == 0) return PathForm::cranks;
  return angled == 3 ? PathForm::ground_pivot : PathForm::curve_of_arms;
}

double crank_sense(const PathTask& task) {
  const std::vector<std::size_t> timed = timed_points(task);
  double sense = 1;
  if (timed.size() > 1)
    sense = turned(task, timed[1]);
  else if (const auto& derivatives = task.points[timed.front()].derivatives; !derivatives.empty())
    sense = derivatives.front().input.value_or(1);
  return sense < 0 ? -1 : 1;
}

namespace {

// All points have an angle of the crank, and nothing else is given.
void check_timed(const PathTask& task, std::vector<Error>& found) {
  if (task.pivots.count() == 0)
    check_count(task, found);
  else
    check_count_for_timed_pivots(task, found);
}

void check_counts(const PathTask& task, std::vector<Error>& found) {
  const int angled = task.angled_count();
  if (angled == 0 && (!task.points.empty() || task.pivots.count() > 0)) {
    check_something_is_given(task, found);
    if (found.empty()) check_count_for_pivots(task, found);
    if (found.empty() && task.form() == PathForm::few) check_places_between_pivots(task, found);
  } else if (angled == position_count(task.points)) {
    check_timed(task, found);
  } else {
    check_count_of_mixed(task, found);
  }
}

}  // namespace

std::vector<Error> mistakes_in(const PathTask& task) {
  using Check = void (*)(const PathTask&, std::vector<Error>&);
  constexpr std::array<Check, 11> checks = {check_numbers,    check_kinds_of_angles, check_counts,     check_box,
                                            check_pivots,     check_equal_angles,    check_sequence,   check_rates,
                                            check_directions, check_same_poses,      check_repetitions};
  std::vector<Error> found;
  if (task.is_approximate()) return mistakes_in_nearest(task);
  for (const auto check : checks)
    if (found.empty()) check(task, found);
  return found;
}

std::vector<PrescribedPose> angled_poses(const PathTask& task) {
  std::vector<PrescribedPose> poses;
  for (const std::size_t i : points_that(task, is_angled)) {
    const PathPoint& point = task.points[i];
    PrescribedPose pose{{point.point, point.angle ? *point.angle : turned(task, i)}, {}};
    for (const PathDerivative& d : point.derivatives)
      pose.derivatives.push_back({d.point, point.angle
                                               ? d.angle.value_or(0)
                                               : d.input.value_or(pose.derivatives.empty() ? crank_sense(task) : 0)});
    poses.push_back(std::move(pose));
  }
  return poses;
}

}  // namespace linkwright
