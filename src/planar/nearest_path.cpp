#include "nearest_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/number_check.hpp"
#include "linkwright/core/tolerance.hpp"
#include "path_points.hpp"

namespace linkwright {
namespace {

bool is_at(const PathPoint& one, const PathPoint& other, double extent) {
  constexpr double least = 1e-60;  // of which a fit's fourth powers still are numbers of full precision
  return std::abs(one.point - other.point) <= std::max(tolerance::repeated_pose * extent, least);
}

void check_near_numbers(const PathTask& task, std::vector<Error>& found) {
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const PathPoint& point = task.points[i];
    check_number(point.point.real(), "x", place_of_path_point(i) + ".x", found);
    check_number(point.point.imag(), "y", place_of_path_point(i) + ".y", found);
    if (point.input) check_angle(*point.input, "input_deg", place_of_path_point(i) + ".input_deg", found);
  }
}

void check_nothing_else(const PathTask& task, std::vector<Error>& found) {
  if (task.box)
    found.push_back({"nearest_with_box", "options.box",
                     "a box goes with five points that are passed exactly; leave it out, and require "
                     "\"ground_pivots_within\" instead"});
  for (std::size_t i = 0; i < task.points.size() && found.empty(); ++i) {
    const PathPoint& point = task.points[i];
    if (point.angle)
      found.push_back({"nearest_with_angles", place_of_path_point(i) + ".theta_deg",
                       "a path that passes near its points has no angles of the coupler; leave it out here, or give at "
                       "most five points and neither \"closed\", \"tolerance\" nor \"weight\", which are then passed "
                       "exactly"});
    else if (!point.derivatives.empty())
      found.push_back({"nearest_with_derivatives", place_of_path_point(i) + ".derivatives",
                       "a path that passes near its points has no directions; leave them out"});
  }
}

// All points have an angle of the crank, or none.
void check_timing(const PathTask& task, std::vector<Error>& found) {
  const auto is_timed = [](const PathPoint& point) { return point.input.has_value(); };
  const auto timed = std::find_if(task.points.begin(), task.points.end(), is_timed);
  const auto untimed = std::find_if_not(task.points.begin(), task.points.end(), is_timed);
  const auto place = [&](auto point) {
    return place_of_path_point(static_cast<std::size_t>(point - task.points.begin())) + ".input_deg";
  };
  const CrankTiming timing = task.near_timing();
  if (task.crank_timing && timing != CrankTiming::free && timed == task.points.end())
    found.push_back({"timing_without_angles", "task.timing",
                     "angles of the crank are to count, and no point has one; give \"input_deg\" at all points, or "
                     "leave \"timing\" out"});
  else if (task.crank_timing && timing == CrankTiming::free && timed != task.points.end())
    found.push_back({"angles_of_free_timing", place(timed),
                     "with \"timing\": \"free\" angles of the crank do not count; leave them out, or say "
                     "\"relative\" or \"absolute\""});
  else if (timed != task.points.end() && untimed != task.points.end())
    found.push_back({"nearest_with_some_angles", place(untimed),
                     "a path that passes near its points has the angle of the crank at all of them or at none; give "
                     "it here, too, or leave out the others"});
  else if (timing != CrankTiming::free && task.between == PathBetween::polyline)
    found.push_back({"timed_polyline", "task.between",
                     "between points at angles of the crank none are given, so that the path is free there; leave "
                     "\"between\" out, or the angles"});
  else if (timing != CrankTiming::free && (task.pivots.count() > 0 || task.map == NearestMap::pivots))
    found.push_back({"timed_near_with_pivots", task.pivots.count() > 0 ? "task.given" : "task.map",
                     "points that are passed near at angles of the crank go without ground pivots that are given, and "
                     "without their map; leave them out, and require \"ground_pivots_within\" instead"});
  else if (timed != task.points.end())
    found = mistakes_in_crank_angles(task);
}

void check_map(const PathTask& task, std::vector<Error>& found) {
  if (task.map == NearestMap::pivots && task.pivots.count() > 0)
    found.push_back({"pivot_map_with_pivots", "task.map",
                     "places of a ground pivot are mapped where none is given; leave the pivots out, or the map"});
}

void check_near_count(const PathTask& task, std::vector<Error>& found) {
  constexpr std::size_t fewest = 3;
  const double extent = extent_of(task);
  std::vector<PathPoint> different;
  for (const PathPoint& point : task.points) {
    if (different.size() >= fewest) break;
    if (std::none_of(different.begin(), different.end(),
                     [&](const PathPoint& known) { return is_at(known, point, extent); }))
      different.push_back(point);
  }
  if (different.size() < fewest)
    found.push_back(
        {"too_few_near_points",
         "task.points",
         fmt::format("{} different point{} {} given, and a path is fitted to three or more; add points",
                     different.size(), different.size() == 1 ? "" : "s", different.size() == 1 ? "was" : "were"),
         {{"count", static_cast<double>(different.size())}}});
  if (task.points.size() > PathTask::most_points)
    found.push_back(
        {"too_many_near_points",
         "task.points",
         fmt::format("{} points were given, and {} are the most that a path is fitted to; leave some out",
                     task.points.size(), PathTask::most_points),
         {{"count", static_cast<double>(task.points.size())}, {"most", static_cast<double>(PathTask::most_points)}}});
}

void check_tolerance(const std::optional<double>& given, const std::string& place, std::vector<Error>& found) {
  if (given && !(*given > 0 && *given <= largest_coordinate))
    found.push_back({"path_tolerance", place, "a tolerance is a length above 0; leave it out where there is none"});
}

void check_tolerances(const PathTask& task, std::vector<Error>& found) {
  check_tolerance(task.tolerance, "task.tolerance", found);
  bool has_weight = false;
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const PathPoint& point = task.points[i];
    check_tolerance(point.tolerance, place_of_path_point(i) + ".tolerance", found);
    const double weight = point.weight.value_or(1);
    if (!(weight >= 0 && weight <= largest_coordinate))
      found.push_back({"path_weight", place_of_path_point(i) + ".weight", "a weight is a number of 0 or more"});
    has_weight = has_weight || weight > 0;
  }
  if (!has_weight)
    found.push_back(
        {"no_path_weight", "task.points", "all points have weight 0, so that any path would do; give some"});
}

}  // namespace

std::string_view name(PathBetween between) { return between == PathBetween::free ? "free" : "polyline"; }

std::string_view name(CrankTiming timing) {
  constexpr std::array names = {"free", "relative", "absolute"};
  return names[static_cast<std::size_t>(timing)];
}

std::string_view name(NearestMap map) { return map == NearestMap::curves ? "curves" : "pivots"; }

bool PathTask::asks_for_nearest() const {
  return closed || tolerance || between || map || crank_timing ||
         std::any_of(points.begin(), points.end(),
                     [](const PathPoint& point) { return point.tolerance || point.weight; });
}

bool PathTask::is_approximate() const {
  constexpr int most_exact = 5;
  if (asks_for_nearest()) return true;
  const int positions = position_count(points);
  const bool all_timed = is_timed() && positions == static_cast<int>(points.size());
  return pivots.count() == 0 && !box && (angled_count() == 0 || all_timed) && positions > most_exact;
}

CrankTiming PathTask::near_timing() const {
  return crank_timing.value_or(is_timed() ? CrankTiming::relative : CrankTiming::free);
}

std::optional<double> PathTask::tolerance_at(std::size_t point) const {
  const auto& own = points[point].tolerance;
  return own ? own : tolerance;
}

std::vector<Error> mistakes_in_nearest(const PathTask& task) {
  using Check = void (*)(const PathTask&, std::vector<Error>&);
  constexpr std::array<Check, 7> checks = {check_near_numbers, check_nothing_else, check_timing,    check_map,
                                           check_near_count,   check_pivots,       check_tolerances};
  std::vector<Error> found;
  for (const auto check : checks)
    if (found.empty()) check(task, found);
  return found;
}

namespace {

Notice left_out(std::string_view code, std::string_view why, const std::vector<std::size_t>& points) {
  constexpr std::size_t most_named = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(points.size(), most_named); ++i)
    list += fmt::format("{}{}", i == 0 ? "" : ", ", points[i] + 1);
  if (points.size() > most_named) list += ", …";
  return {std::string(code),
          fmt::format("{} {}: {}.", points.size() == 1 ? "A point was left out," : "Points were left out,", why, list),
          {{"points", std::string_view(list)}, {"count", static_cast<double>(points.size())}}};
}

// Where no weight at all is given beside a tolerance, points with a small one count the more.
double weight_of(const PathTask& task, std::size_t point, double unit) {
  const auto tolerance = task.tolerance_at(point);
  const double by_tolerance = tolerance ? unit / *tolerance : 1;
  return task.points[point].weight.value_or(1) * by_tolerance * by_tolerance;
}

// So that weights are about 1: the least of what weighs anything.
double tolerance_unit(const PathTask& task) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < task.points.size(); ++i)
    if (task.points[i].weight.value_or(1) > 0) least = std::min(least, task.tolerance_at(i).value_or(least));
  return std::isfinite(least) ? least : 1;
}

// Takes a point into the target; one at the place of another of its points instead makes that one stricter.
void take_point(const PathTask& task, std::size_t i, double unit, NearestTarget& near, std::size_t at) {
  if (at == near.point.size()) {
    near.point.push_back(i);
    near.target.points.push_back(task.points[i].point);
    near.target.weights.push_back(0);
    near.tolerance.push_back(std::numeric_limits<double>::infinity());
  }
  near.target.weights[at] = std::max(near.target.weights[at], weight_of(task, i, unit));
  near.tolerance[at] = std::min(near.tolerance[at], task.tolerance_at(i).value_or(near.tolerance[at]));
}

// Of each side of the polygon its middle, as a point of a quarter of the weight.
void put_middles_between(NearestTarget& near) {
  constexpr double share = 0.25;
  const NearestTarget given =
      std::exchange(near, {{{}, {}, near.target.closed}, {}, {}, {}, near.pivots, std::move(near.warnings)});
  const std::size_t count = given.point.size();
  for (std::size_t j = 0; j < count; ++j) {
    near.target.points.push_back(given.target.points[j]);
    near.target.weights.push_back(given.target.weights[j]);
    near.point.push_back(given.point[j]);
    near.tolerance.push_back(given.tolerance[j]);
    if (j + 1 == count && !near.target.closed) return;
    const std::size_t next = (j + 1) % count;
    near.target.points.push_back(0.5 * (given.target.points[j] + given.target.points[next]));
    near.target.weights.push_back(share * std::min(given.target.weights[j], given.target.weights[next]));
    near.point.push_back(NearestTarget::between);
    near.tolerance.push_back(std::numeric_limits<double>::infinity());
  }
}

// At one place a crank may turn on: none is left out.
NearestTarget timed_target(const PathTask& task) {
  NearestTarget near;
  near.target.closed = task.closed;
  near.timing = CurveTiming{{}, task.near_timing() == CrankTiming::absolute};
  const double unit = tolerance_unit(task);
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    take_point(task, i, unit, near, near.point.size());
    near.timing->input.push_back(*task.points[i].input);
  }
  return near;
}

}  // namespace

CurveError NearestTarget::error_of(const CurveFit& fit) const {
  CurveError error = fit.error;
  error.sum_of_squares = error.max = 0;
  double weights = 0;
  for (std::size_t j = 0; j < fit.states.size(); ++j) {
    if (point[j] == between) continue;
    const double weight = target.weights[j], distance = fit.states[j].distance;
    weights += weight;
    error.sum_of_squares += weight * distance * distance;
    if (!(weight > 0 && distance >= error.max)) continue;
    error.max = distance;
    error.max_at = point[j];
  }
  error.rms = std::sqrt(error.sum_of_squares / weights);
  error.rms_over_diagonal = error.rms / target.diagonal();
  return error;
}

NearestTarget nearest_target(const PathTask& task) {
  NearestTarget near;
  near.target.closed = task.closed;
  if (task.near_timing() != CrankTiming::free) return timed_target(task);
  near.pivots = task.pivots;
  const double extent = extent_of(task), unit = tolerance_unit(task);
  std::vector<std::size_t> repeated, closing;
  std::size_t last = task.points.size();
  while (task.closed && last > 3 && is_at(task.points[last - 1], task.points.front(), extent))
    closing.push_back(--last);
  for (std::size_t i = 0; i < task.points.size(); ++i) {
    const bool repeats = !near.point.empty() && is_at(task.points[i], task.points[near.point.back()], extent);
    if (repeats && i < last) repeated.push_back(i);
    take_point(task, i, unit, near, i >= last ? 0 : repeats ? near.point.size() - 1 : near.point.size());
  }
  if (task.between == PathBetween::polyline) put_middles_between(near);
  if (!repeated.empty())
    near.warnings.push_back(left_out("path_points_repeated", "each at the place of the point before", repeated));
  if (!closing.empty())
    near.warnings.push_back(left_out("path_point_closes", "a closed path comes back to its first by itself", closing));
  return near;
}

}  // namespace linkwright
