#include "linkwright/region/objective.hpp"

#include <array>
#include <gtest/gtest.h>
#include <set>
#include <string_view>

namespace linkwright::objective_test {
namespace {

TEST(Objective, HasTheKeyOfTheProblemFile) {
  EXPECT_EQ(name(Objective::min_transmission_angle), "min_transmission_angle");
  EXPECT_EQ(name(Objective::structural_error), "structural_error");
  EXPECT_EQ(name(Objective::link_angle), "link_angle");
}

TEST(Objective, EachIsNamedAndPraisedInItsOwnWords) {
  std::set<std::string_view> names, superlatives;
  for (const Objective objective : objectives()) {
    names.insert(name(objective));
    superlatives.insert(superlative(objective));
  }
  EXPECT_EQ(names.size(), objectives().size());
  EXPECT_EQ(superlatives.size(), objectives().size());
  EXPECT_EQ(superlatives.count(""), 0u);
}

TEST(Objective, OfAnAnalysisIsMeasuredByNoFamily) {
  EXPECT_TRUE(is_of_analysis(Objective::yield));
  EXPECT_FALSE(is_of_analysis(Objective::structural_error));
}

TEST(Objective, RanksByItsNumberTheLargerTheBetter) {
  constexpr std::array held = {measures::link_ratio, measures::min_transmission_angle, measures::longest_link,
                               measures::min_link_angle};
  const MapCell cell{LinkageType::crank_rocker, {}, {4, 0.25, 30, 0.5}};
  const auto score = [&](Objective objective) { return rank_of(objective, held).score(cell); };
  EXPECT_EQ(score(Objective::min_transmission_angle), 0.25);
  EXPECT_EQ(score(Objective::link_ratio), -4);
  EXPECT_EQ(score(Objective::size), -30);
  EXPECT_EQ(score(Objective::structural_error), 0.25);
  EXPECT_EQ(score(Objective::link_angle), 0.5);
  EXPECT_EQ(score(Objective::tolerance_error), 0.25) << "which the cell does not hold";
}

TEST(Objective, RanksTheCellsOfAMapByAMeasureOfTheSameSense) {
  EXPECT_EQ(measure_of(Objective::size), measures::longest_link);
  EXPECT_FALSE(measure_of(Objective::size).larger_is_better);
  EXPECT_EQ(measure_of(Objective::link_angle), measures::min_link_angle);
  EXPECT_TRUE(measure_of(Objective::link_angle).larger_is_better);
}

}  // namespace
}  // namespace linkwright::objective_test
