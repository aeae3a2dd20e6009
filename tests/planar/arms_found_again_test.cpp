// Random four-bars, the points that theirs passes, and what else is told of them: the map has the linkage again.

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "linkwright/infinitesimal/motion_series.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/arm_maps.hpp"
#include "support/random_task.hpp"

namespace linkwright::arms_found_again_test {
namespace {

using testing::anything;
using testing::arms_of;
using testing::curve_coordinate_of;
using testing::nearest_of;
using testing::off;
using testing::place_of;
using testing::uniform;

/// A linkage, its point, and a task that it does.
struct Known {
  FourBar bars;
  Point point{};
  PathTask task;
};

/// What is known at a point beside its place.
enum class Angle { none, crank, coupler };

PathPoint prescribed(const FourBar& there, Point point, int multiplicity, Angle angle) {
  PathPoint at{point, {}, {}, {}};
  if (angle == Angle::crank) at.input = std::arg(there.input_moving - there.input_fixed);
  if (angle == Angle::coupler) at.angle = std::arg(there.output_moving - there.input_moving);
  const auto loop = loop_series(there);
  if (!loop) return at;
  const MotionSeries motion = coupler_motion(there, *loop);
  const auto path = motion.path_of(point);
  double factorial = 1;
  for (int m = 1; m < multiplicity; ++m) {
    factorial *= m;
    const auto k = static_cast<std::size_t>(m);
    at.derivatives.push_back({factorial * path.c[k], {}, {}});
    if (angle == Angle::crank) at.derivatives.back().input = factorial * loop->input.c[k];
    if (angle == Angle::coupler) at.derivatives.back().angle = factorial * motion.turn.c[k];
  }
  return at;
}

/// `angles`: those known, of all points; none: of no point.
Known random_known(std::mt19937_64& random, const std::vector<int>& pattern, bool input, bool output,
                   const std::vector<Angle>& known_angles = {}) {
  Known known;
  const Point shift{uniform(random, -50, 50), uniform(random, -50, 50)};
  const auto place = [&] { return shift + Point{uniform(random, -3, 3), uniform(random, -3, 3)}; };
  const FourBar any{place(), place(), place(), place()};
  const Point point = place();
  const Point along = (point - any.input_moving) / (any.output_moving - any.input_moving);
  const auto ranges = input_ranges(any.lengths());
  const Assembly assembly = assembly_of(any);
  std::vector<double> angles;
  for (std::size_t j = 0; j < pattern.size(); ++j) angles.push_back(uniform(random, 0.05, 0.95));
  std::sort(angles.begin(), angles.end());
  for (std::size_t j = 0; j < pattern.size(); ++j) {
    const AngleRange& range = ranges.front();
    const double angle = range.from + (range.to - range.from) * angles[j];
    const FourBar there = placed(any, assemble(any.lengths(), angle, assembly).value());
    if (j == 0) known.bars = there;
    const Point at = there.input_moving + along * (there.output_moving - there.input_moving);
    if (j == 0) known.point = at;
    known.task.points.push_back(
        prescribed(there, at, pattern[j], known_angles.empty() ? Angle::none : known_angles[j]));
  }
  if (input) known.task.pivots.input = any.input_fixed;
  if (output) known.task.pivots.output = any.output_fixed;
  return known;
}

double relative_error(const Known& known) {
  const bool by_input = known.task.pivots.input.has_value();
  const FourBar& bars = known.bars;
  const double link = by_input ? bars.lengths().input : bars.lengths().output;
  const double reach = std::abs(known.point - (by_input ? bars.input_moving : bars.output_moving));
  const auto cells = arms_of(known.task)->all_at(place_of(known.task, link, reach), false);
  return off(nearest_of(cells, bars), bars) / bars.lengths().longest();
}

void expect_found(const std::vector<int>& pattern, bool input, bool output) {
  std::mt19937_64 random(20131);
  int close = 0;
  constexpr int tasks = 30;
  std::vector<double> errors;
  for (int i = 0; i < tasks; ++i) {
    errors.push_back(relative_error(random_known(random, pattern, input, output)));
    close += errors.back() < 1e-6;
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_GE(close, tasks - 1) << ::testing::PrintToString(pattern);  // points so close that digits are lost
  EXPECT_LT(errors[tasks / 2], 1e-11) << ::testing::PrintToString(pattern);
}

TEST(ArmsFoundAgain, FindsTheLinkageThatDrewThePoints) {
  for (const bool of_input : {true, false})
    for (const std::vector<int>& pattern : std::vector<std::vector<int>>{
             {1, 1, 1, 1, 1}, {2, 1, 1, 1}, {1, 1, 2, 1}, {2, 1, 2}, {3, 1, 1}, {1, 3, 1}, {3, 2}, {4, 1}, {5}})
      expect_found(pattern, of_input, !of_input);
  for (const std::vector<int>& pattern : std::vector<std::vector<int>>{{1, 1, 1}, {2, 1}, {1, 2}, {3}})
    expect_found(pattern, true, true);
}

/// Where the known linkage stands on the map, nothing given of it beside points and angles, or one ground pivot.
std::vector<Cell> cells_with(const Known& known, const ArmFamily& family, bool by_crank) {
  const PathTask& task = known.task;
  if (task.form() == PathForm::other_pivot)
    return family.all_at(place_of(task, task.pivots.input ? known.bars.output_fixed : known.bars.input_fixed), false);
  if (task.form() == PathForm::ground_pivot) return family.all_at(place_of(task, known.bars.input_fixed), false);
  if (task.form() == PathForm::few) return family.all_at(family.few_places().at(0), false);
  // Of a body that turns with the crank, from the first point on: where it carries the end of the parallelogram.
  const Point circle =
      by_crank ? known.bars.input_fixed + known.point - known.bars.input_moving : known.bars.input_moving;
  std::vector<Cell> cells;
  const double tau = curve_coordinate_of(task, circle);
  for (const double number : family.samples(Side::output, 0, Spacing::coordinate))
    if (const auto cell = family.cell({tau, number}, false)) cells.push_back(*cell);
  return cells;
}

struct Mix {
  std::vector<int> pattern;
  std::vector<bool> has_angle;
};

void expect_found(const Mix& mix, Angle kind, bool input, bool output) {
  std::mt19937_64 random(20132);
  constexpr int tasks = 30;
  std::vector<double> errors;
  std::vector<Angle> angles;
  for (const bool has : mix.has_angle) angles.push_back(has ? kind : Angle::none);
  while (errors.size() < tasks) {
    const Known known = random_known(random, mix.pattern, input, output, angles);
    if (!mistakes_in(known.task).empty()) continue;  // a crank that turned back
    const auto cells = cells_with(known, *arms_of(known.task), kind == Angle::crank);
    errors.push_back(off(nearest_of(cells, known.bars), known.bars) / known.bars.lengths().longest());
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[tasks - 2], 1e-6) << ::testing::PrintToString(mix.pattern);
  EXPECT_LT(errors[tasks / 2], 1e-10) << ::testing::PrintToString(mix.pattern);
}

TEST(ArmsFoundAgain, FindsTheLinkageThatDrewPointsAmongAngles) {
  const std::vector<Mix> three_and_two = {{{1, 1, 1, 1, 1}, {true, true, true, false, false}},
                                          {{1, 1, 1, 1, 1}, {false, true, false, true, true}},
                                          {{2, 1, 1, 1}, {true, false, true, false}},
                                          {{1, 2, 1, 1}, {false, true, true, false}},
                                          {{3, 1, 1}, {true, false, false}},
                                          {{2, 1, 2}, {true, true, false}},
                                          {{2, 3}, {false, true}}};
  const std::vector<Mix> four_and_one = {{{1, 1, 1, 1, 1}, {true, true, true, true, false}},
                                         {{1, 1, 1, 1, 1}, {true, false, true, true, true}},
                                         {{2, 2, 1}, {true, true, false}},
                                         {{3, 1, 1}, {true, false, true}}};
  for (const Angle kind : {Angle::crank, Angle::coupler}) {
    for (const Mix& mix : three_and_two) expect_found(mix, kind, false, false);
    for (const Mix& mix : four_and_one) expect_found(mix, kind, false, false);
  }
}

TEST(ArmsFoundAgain, FindsTheLinkageThatDrewTimedPointsAboutAPivot) {
  for (const std::vector<int>& pattern : std::vector<std::vector<int>>{{1, 1, 1}, {2, 1}, {1, 2}, {3}}) {
    const Mix mix{pattern, std::vector<bool>(pattern.size(), true)};
    expect_found(mix, Angle::crank, true, false);
    expect_found(mix, Angle::crank, false, true);
    expect_found(mix, Angle::crank, true, true);
  }
}

}  // namespace
}  // namespace linkwright::arms_found_again_test
