#include "planar/pivot_path_family.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "support/solved.hpp"

namespace linkwright::pivot_path_family_test {
namespace {

PathTask drawn_bean() {
  PathTask task;
  task.closed = true;
  for (int j = 0; j < 16; ++j) {
    const double angle = 2 * 3.14159265358979 * j / 16, radius = 40 * (1 + 0.25 * std::sin(2 * angle));
    task.points.push_back({{100 + 1.6 * radius * std::cos(angle), 50 + radius * std::sin(angle)}, {}, {}, {}, {}, {}});
  }
  return task;
}

TaskFamily family_of(NearestMap map) {
  PathTask task = drawn_bean();
  task.map = map;
  FitWishes wishes;
  wishes.effort = FitEffort::quick;
  return family_of_nearest(task, Requirements{}, wishes, RegionOptions{});
}

TEST(PivotPathFamily, PutsTheInputsGroundPivotWhereTheMapSays) {
  const TaskFamily given = family_of(NearestMap::pivots);
  ASSERT_TRUE(given.family);
  const LinkageFamily& family = *given.family;
  int found = 0;
  for (double input = 0.15; input < 1; input += 0.14)
    for (double output = 0.15; output < 1; output += 0.14) {
      const auto cell = family.cell({input, output});
      if (!cell) continue;
      ++found;
      const Vector3 pivot = cell->pivots.ground[0];
      EXPECT_NEAR(pivot.x, family.axis_value(Side::output, output), 1e-6 * given.size);
      EXPECT_NEAR(pivot.y, family.axis_value(Side::input, input), 1e-6 * given.size);
      EXPECT_GT(cell->values[planar_measures.size()], 0);
    }
  EXPECT_GT(found, 20);
}

TEST(PivotPathFamily, MapAndCellsAgree) {
  const TaskFamily given = family_of(NearestMap::pivots);
  ASSERT_TRUE(given.family);
  const std::vector<double> places = {0.2, 0.41, 0.55, 0.8};
  RegionMap map;
  given.family->classify(map, places, places, true);
  for (std::size_t row = 0; row < places.size(); ++row)
    for (std::size_t column = 0; column < places.size(); ++column) {
      const auto cell = given.family->cell({places[row], places[column]});
      if (!cell) {
        EXPECT_EQ(map.type(map.index(row, column)), LinkageType::degenerate);
        continue;
      }
      EXPECT_EQ(map.type(map.index(row, column)), cell->type);
      EXPECT_EQ(map.defects()[map.index(row, column)], cell->defects.bits);
    }
}

TEST(PivotPathFamily, KnowsTheCurvesThatWereFoundAtTheirPivots) {
  const TaskFamily curves = family_of(NearestMap::curves), given = family_of(NearestMap::pivots);
  ASSERT_TRUE(given.family && curves.family);
  const std::vector<MapPoint> known = given.family->known_places();
  ASSERT_FALSE(known.empty());
  const auto best = curves.family->cell({0.5, 0.5}), there = given.family->cell(known.front());
  ASSERT_TRUE(best && there);
  EXPECT_LE(there->values[planar_measures.size()], (1 + 1e-6) * best->values[planar_measures.size()]);
  EXPECT_TRUE(there->defects.none());
}

}  // namespace
}  // namespace linkwright::pivot_path_family_test
