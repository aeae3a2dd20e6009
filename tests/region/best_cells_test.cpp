#include "linkwright/region/best_cells.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "linkwright/planar/pose_conditions.hpp"
#include "support/case_region.hpp"
#include "support/planar_case.hpp"

namespace linkwright::best_cells_test {
namespace {

class BestCells : public ::testing::Test {
 protected:
  BestCells() { wanted.max_length = 5000; }
  [[nodiscard]] double score(Objective objective, std::size_t cell) const {
    const Measure& by = measure_of(objective);
    return (by.larger_is_better ? 1 : -1) * static_cast<double>(map.values(by)[cell]);
  }

  std::vector<PrescribedPose> poses = testing::planar_case("landing_gear").poses;
  WorkingFrame frame = pose_conditions(poses).frame;
  RegionMap map = testing::region_of(poses, 250);
  Requirements wanted;
};

constexpr std::array<Objective, 3> objectives = {Objective::min_transmission_angle, Objective::link_ratio,
                                                 Objective::size};

TEST_F(BestCells, FirstHillTopIsTheBestCellOfAll) {
  const RequirementFilter filter(map, wanted);
  for (const Objective objective : objectives) {
    double best = -1e300;
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < map.columns(); ++column)
        if (filter.passes(row, column)) best = std::max(best, score(objective, map.index(row, column)));
    const auto tops = hill_tops(map, filter, objective, 50);
    ASSERT_FALSE(tops.empty());
    EXPECT_EQ(tops[0].score, best) << name(objective);
    EXPECT_TRUE(std::is_sorted(tops.begin(), tops.end(), [](auto a, auto b) { return a.score > b.score; }));
  }
}

TEST_F(BestCells, NoNeighbourOfTheSameTypeIsBetter) {
  const RequirementFilter filter(map, wanted);
  for (const RankedCell& top : hill_tops(map, filter, Objective::min_transmission_angle, 1000)) {
    EXPECT_TRUE(filter.passes(top.row, top.column));
    for (std::size_t row = top.row - (top.row > 0); row <= std::min(top.row + 1, map.rows() - 1); ++row) {
      const std::size_t other = map.index(row, top.column);
      const bool same_branch = std::floor(map.input_coordinates()[row]) == std::floor(map.input_coordinates()[top.row]);
      if (!same_branch || !filter.passes(row, top.column)) continue;
      if (map.type(other) != map.type(map.index(top.row, top.column))) continue;
      EXPECT_LE(score(Objective::min_transmission_angle, other), top.score);
    }
  }
}

TEST_F(BestCells, AreAtMostAsManyAsAsked) {
  const RequirementFilter filter(map, wanted);
  EXPECT_EQ(hill_tops(map, filter, Objective::size, 1).size(), 1u);
}

TEST_F(BestCells, TilesHoldOneCellEach) {
  const RequirementFilter filter(map, wanted);
  const auto cells = tile_bests(map, filter, Objective::link_ratio, 10);
  EXPECT_LE(cells.size(), 100u);
  EXPECT_EQ(cells[0].score, hill_tops(map, filter, Objective::link_ratio, 1)[0].score);
  for (const RankedCell& cell : cells) EXPECT_TRUE(filter.passes(cell.row, cell.column));
}

TEST_F(BestCells, NothingPassesNothingIsFound) {
  wanted.max_length = 1e-3;
  const RequirementFilter filter(map, wanted);
  EXPECT_TRUE(hill_tops(map, filter, Objective::size, 10).empty());
  EXPECT_TRUE(tile_bests(map, filter, Objective::size, 10).empty());
}

const std::vector<float> values = {1, 5, 3,  //
                                   4, 9, 2};
const std::vector<FailureBits> failures = {0, 0, 0,  //
                                           0, 1, 0};

TEST(Ridges, HoldTheBestOfEachRowAndColumn) {
  const Ridges found = ridges(values, failures, 3, true);
  EXPECT_EQ(found.input.value, (std::vector<float>{5, 4}));
  EXPECT_EQ(found.input.partner, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(found.output.value, (std::vector<float>{4, 5, 3}));
  EXPECT_EQ(found.output.partner, (std::vector<std::uint32_t>{1, 0, 0}));
}

TEST(Ridges, SmallestWhereSmallerIsBetter) {
  const Ridges found = ridges(values, failures, 3, false);
  EXPECT_EQ(found.input.value, (std::vector<float>{1, 2}));
  EXPECT_EQ(found.output.partner, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(Ridges, AreZeroWhereNothingPasses) {
  const Ridges found = ridges(values, std::vector<FailureBits>(6, 4), 3, true);
  EXPECT_EQ(found.input.value, (std::vector<float>{0, 0}));
  EXPECT_TRUE(ridges({}, {}, 0, true).input.value.empty());
}

}  // namespace
}  // namespace linkwright::best_cells_test
