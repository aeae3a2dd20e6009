#include "linkwright/planar/fitted_path.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "planar/fitted_path_family.hpp"
#include "planar/length_check.hpp"

namespace linkwright::fitted_path_test {
namespace {

PathTask oval() {
  PathTask task;
  for (int k = 0; k < 14; ++k) {
    const double t = two_pi * k / 14;
    task.points.push_back({{80 * std::cos(t), 30 * std::sin(t) + 12 * std::sin(2 * t)}, {}, {}, {}, {}, {}});
  }
  task.closed = true;
  return task;
}

TaskFamily family_of(const PathTask& task) {
  FitWishes wishes;
  wishes.effort = FitEffort::quick;
  return family_of_nearest(task, {}, wishes, {});
}

TEST(FittedPath, HasPositionsThatItsLinksReach) {
  const TaskFamily given = family_of(oval());
  ASSERT_TRUE(given.paths);
  for (const MapPoint place : given.paths->few_places()) {
    const auto links = given.paths->dyad_pair(place);
    if (!links) continue;
    const FourBar bars = given.frame().to_user(*four_bar_of(*links));
    const auto poses = given.paths->user_poses(place, bars);
    ASSERT_EQ(poses.size(), 5u);
    const LengthCheck lengths(poses);
    EXPECT_LT(lengths.residual(bars.input_fixed, bars.input_moving), 1e-10);
    EXPECT_LT(lengths.residual(bars.output_fixed, bars.output_moving), 1e-10);
  }
}

TEST(FittedPath, HasCellsWithItsErrorThatAreGoodOnlyWhereTheInputTurnsFully) {
  const TaskFamily given = family_of(oval());
  ASSERT_TRUE(given.paths);
  int good = 0;
  for (const MapPoint place : given.paths->few_places()) {
    const auto cell = given.paths->cell(place);
    if (!cell) continue;
    EXPECT_DOUBLE_EQ(cell->values[4], given.paths->fitted_at(place)->error.rms);
    EXPECT_EQ(cell->values[0], cell->values[1]) << "it is run all along";
    if (!cell->defects.none()) continue;
    ++good;
    EXPECT_TRUE(input_is_crank(cell->type));
  }
  EXPECT_GT(good, 0);
}

TEST(FittedPath, IsRankedByTheLargestDistanceWhereThatIsToBeLeast) {
  FitWishes wishes;
  wishes.effort = FitEffort::quick;
  wishes.measure = FitMeasure::least_largest;
  const TaskFamily given = family_of_nearest(oval(), {}, wishes, {});
  ASSERT_TRUE(given.paths);
  for (const MapPoint place : given.paths->few_places()) {
    const auto cell = given.paths->cell(place);
    if (!cell) continue;
    EXPECT_DOUBLE_EQ(cell->values[4], given.paths->fitted_at(place)->error.max);
  }
}

TEST(FittedPath, StandsOnThePivotsThatAreGiven) {
  for (const bool both : {false, true}) {
    PathTask task = oval();
    task.pivots.input = Point{-40, -95};
    if (both) task.pivots.output = Point{70, -90};
    const TaskFamily given = family_of(task);
    ASSERT_TRUE(given.paths) << both;
    int cells = 0;
    for (const MapPoint place : given.paths->few_places()) {
      const auto cell = given.paths->cell(place);
      if (!cell) continue;
      ++cells;
      EXPECT_NEAR(cell->pivots.ground[0].x, -40, 1e-3);
      EXPECT_NEAR(cell->pivots.ground[0].y, -95, 1e-3);
      if (both) {
        EXPECT_NEAR(cell->pivots.ground[1].x, 70, 1e-3);
      }
    }
    EXPECT_GT(cells, 0);
  }
}

TEST(FittedPath, KeepsOffDeadPoints) {
  PathTask task;  // the nearest paths without that would reach a dead point at one of these
  for (const Point place : {Point{95.1, 112.1}, Point{105.3, 111.7}, Point{108.7, 109.1}, Point{106.8, 106.4},
                            Point{101.2, 103.8}, Point{93.8, 99.9}, Point{85.1, 94.6}, Point{76.3, 88.1},
                            Point{68.6, 81.9}, Point{62.2, 76}, Point{56.1, 72.9}, Point{50.7, 70.2}})
    task.points.push_back({place, {}, {}, {}, {}, {}});
  const TaskFamily given = family_of(task);
  ASSERT_TRUE(given.paths);
  int usable = 0;
  for (const MapPoint place : given.paths->few_places()) {
    const auto cell = given.paths->cell(place);
    if (!cell || !cell->defects.none()) continue;
    ++usable;
    EXPECT_GT(cell->values[0], 0.9 * (1 - std::cos(1e-3))) << "a versine";
  }
  EXPECT_GT(usable, 0);
}

TEST(FittedPath, HasThreeFourBarsThatAreOneDesign) {
  const TaskFamily given = family_of(oval());
  ASSERT_TRUE(given.paths);
  const std::vector<Cell> all = given.paths->all_at({0.5, 0.5}, true);
  ASSERT_EQ(all.size(), 3u);
  for (const Cell& cell : all) EXPECT_EQ(given.paths->distance(all.front().pivots, cell.pivots), 0);
  const auto other = given.paths->cell({1.5, 0.5});
  ASSERT_TRUE(other);
  EXPECT_GT(given.paths->distance(all.front().pivots, other->pivots), 0);
  for (const Cell& cell : all) {
    const auto fit = given.paths->fitted_at(cell.place);
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->realisations.size(), 3u);
    EXPECT_NEAR(std::abs(fit->realisations.front().input_fixed - four_bar_of(cell.pivots).input_fixed), 0, 1e-9);
  }
}

TEST(FittedPath, TellsErrorsOfThePointsAlone) {
  PathTask task = oval();
  task.between = PathBetween::polyline;
  const TaskFamily given = family_of(task);
  ASSERT_TRUE(given.paths);
  const auto fit = given.paths->fitted_at({0.5, 0.5});
  ASSERT_TRUE(fit);
  ASSERT_EQ(fit->at.size(), 14u);
  double squares = 0, largest = 0;
  for (const FittedPath::Nearest& at : fit->at) {
    squares += at.distance * at.distance;
    largest = std::max(largest, at.distance);
    EXPECT_NEAR(std::abs(at.place - task.points[at.point].point), at.distance, 1e-12 * 80);
  }
  EXPECT_NEAR(fit->error.rms, std::sqrt(squares / 14), 1e-12);
  EXPECT_EQ(fit->error.max, largest);
}

TEST(FittedPath, SaysByHowMuchTheBestMissesTheToleranceOfPointsAlone) {
  PathTask task = oval();
  task.between = PathBetween::polyline;
  task.tolerance = 1e-4;
  task.points[9].tolerance = 1e-2;
  const TaskFamily given = family_of(task);
  ASSERT_TRUE(given.paths);
  double least = 1e300;
  for (const MapPoint place : given.paths->few_places()) {
    const auto fit = given.paths->fitted_at(place);
    double factor = 0;
    for (std::size_t j = 0; fit && j < task.points.size(); ++j)
      factor = std::max(factor, fit->at[j].distance / *task.tolerance_at(j));
    if (fit) least = std::min(least, factor);
  }
  const auto told = std::find_if(given.warnings.begin(), given.warnings.end(),
                                 [](const Notice& notice) { return notice.code == "path_tolerance_missed"; });
  ASSERT_NE(told, given.warnings.end());
  EXPECT_NEAR(std::get<double>(told->values.front().value), least, 1e-9 * least);
}

TEST(FittedPath, CountsTurnsOfEachInputOnBetweenSparsePoints) {
  PathTask task;
  for (const Point place : {Point{0, 0}, Point{4, 0}, Point{1, 3}}) task.points.push_back({place, {}, {}, {}, {}, {}});
  task.closed = true;
  const TaskFamily given = family_of(task);
  ASSERT_TRUE(given.paths);
  int wide = 0;
  for (const MapPoint place : given.paths->few_places()) {
    const auto cell = given.paths->cell(place);
    if (!cell || !cell->defects.none()) continue;
    const auto at = given.paths->fitted_at(place)->at;
    const double sense = at[1].input > 0 ? 1 : -1;
    EXPECT_GT(sense * (at[2].input - at[1].input), 0);
    EXPECT_LT(sense * at[2].input, two_pi);
    if (sense * at[1].input > pi || sense * (at[2].input - at[1].input) > pi) ++wide;
  }
  EXPECT_GT(wide, 0);
}

TEST(FittedPath, IsNoFamilyWhereNothingKeepsWhatIsAsked) {
  Requirements impossible;
  impossible.max_length = 1e-3;
  impossible.min_length = 1e-4;
  FitWishes wishes;
  wishes.effort = FitEffort::quick;
  const TaskFamily given = family_of_nearest(oval(), impossible, wishes, {});
  EXPECT_FALSE(given.family);
  EXPECT_TRUE(given.has_no_dyads);
  ASSERT_TRUE(given.degeneracy);
  EXPECT_EQ(given.degeneracy->code, "no_path_fits");
}

}  // namespace
}  // namespace linkwright::fitted_path_test
