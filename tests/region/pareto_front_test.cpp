#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright::pareto_front_test {
namespace {

constexpr std::array objectives = {Objective::min_transmission_angle, Objective::size};

/// Cells of random numbers, some of which fail; coarse numbers, so that many are equal.
RegionMap random_map(std::uint64_t seed, std::size_t side, int levels) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> level(1, levels);
  RegionMap map;
  std::vector<double> places(side);
  constexpr std::array held = {measures::min_transmission_angle, measures::longest_link};
  map.evaluate_cells(places, places, held, {},
                     [&](std::size_t, std::size_t) {
                       MapCell cell;
                       cell.type = LinkageType::crank_rocker;
                       cell.defects.bits = level(random) % 7 == 0 ? 1 : 0;
                       cell.values = {static_cast<float>(level(random)) / 100, static_cast<float>(level(random))};
                       return cell;
                     },
                     {.threads = 1});
  return map;
}

Requirements any_length() {
  Requirements wanted;
  wanted.max_length = Requirements::unlimited;
  return wanted;
}

bool beats(const ParetoCell& a, const ParetoCell& b) {
  return a.values[0] >= b.values[0] && a.values[1] <= b.values[1] && a.values != b.values;
}

TEST(ParetoFront, HoldsWhatNothingBeatsAndBeatsOrEqualsAllElse) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const RegionMap map = random_map(seed, 12, seed % 2 == 0 ? 8 : 90);
    const RequirementFilter filter(map, any_length());
    const auto front = pareto_front(map, filter, objectives);
    ASSERT_FALSE(front.empty());
    for (std::size_t row = 0; row < map.rows(); ++row)
      for (std::size_t column = 0; column < map.columns(); ++column) {
        if (!filter.passes(row, column)) continue;
        const std::size_t cell = map.index(row, column);
        const ParetoCell here{row,
                              column,
                              {static_cast<double>(map.values(measures::min_transmission_angle)[cell]),
                               static_cast<double>(map.values(measures::longest_link)[cell])}};
        int beaten = 0, beating = 0;
        for (const ParetoCell& held : front) {
          beaten += beats(held, here) || held.values == here.values;
          beating += beats(here, held);
        }
        EXPECT_GT(beaten, 0);
        EXPECT_EQ(beating, 0);
      }
    for (std::size_t i = 1; i < front.size(); ++i) EXPECT_LT(front[i].values[0], front[i - 1].values[0]);
  }
}

TEST(ParetoFront, LeavesOutWhatHasNoNumber) {
  RegionMap map = random_map(1, 4, 90);
  float* const lengths = map.cells(0).measures[1];
  std::fill_n(lengths, 16, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(pareto_front(map, RequirementFilter(map, any_length()), objectives).empty());
}

TEST(ParetoFront, IsSpreadEvenlyWithBothEnds) {
  std::vector<ParetoCell> front;
  for (std::size_t i = 0; i <= 1000; ++i) {
    const double x = static_cast<double>(i) / 1000;
    front.push_back({i, 0, {1 - x, 500 * (1 - x * x * x)}});
  }
  const auto chosen = spread_over(front, 5);
  ASSERT_EQ(chosen.size(), 5);
  EXPECT_EQ(chosen.front().row, 0);
  EXPECT_EQ(chosen.back().row, 1000);
  for (std::size_t i = 1; i < 5; ++i) {
    const double step =
        chosen[i - 1].values[0] - chosen[i].values[0] + (chosen[i - 1].values[1] - chosen[i].values[1]) / 500;
    EXPECT_NEAR(step, 0.5, 0.01);
  }
  EXPECT_EQ(spread_over(front, 1).front().row, 0);
  EXPECT_EQ(spread_over({front[3]}, 7).size(), 1);
}

}  // namespace
}  // namespace linkwright::pareto_front_test
