#include "linkwright/region/objective.hpp"

#include <gtest/gtest.h>

namespace linkwright::objective_test {
namespace {

constexpr RankedNumbers numbers{0.25, 4, 30, 0.5};

TEST(Objective, HasTheKeyOfTheProblemFile) {
  EXPECT_EQ(name(Objective::min_transmission_angle), "min_transmission_angle");
  EXPECT_EQ(name(Objective::structural_error), "structural_error");
  EXPECT_EQ(name(Objective::link_angle), "link_angle");
}

TEST(Objective, RanksByItsNumberTheLargerTheBetter) {
  EXPECT_EQ(score_of(Objective::min_transmission_angle, numbers), 0.25);
  EXPECT_EQ(score_of(Objective::link_ratio, numbers), -4);
  EXPECT_EQ(score_of(Objective::size, numbers), -30);
  EXPECT_EQ(score_of(Objective::structural_error, numbers), 0.25);
  EXPECT_EQ(score_of(Objective::link_angle, numbers), 0.5);
}

TEST(Objective, RanksTheCellsOfAMapByAMeasureOfTheSameSense) {
  EXPECT_EQ(measure_of(Objective::size), measures::longest_link);
  EXPECT_FALSE(measure_of(Objective::size).larger_is_better);
  EXPECT_EQ(measure_of(Objective::link_angle), measures::min_link_angle);
  EXPECT_TRUE(measure_of(Objective::link_angle).larger_is_better);
}

}  // namespace
}  // namespace linkwright::objective_test
