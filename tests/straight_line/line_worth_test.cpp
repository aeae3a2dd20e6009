#include "linkwright/straight_line/line_worth.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "linkwright/region/objective.hpp"

namespace linkwright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Links 4, 2, 3 and 3, arms 1 and 2: the longest over the shortest is 4.
const TracingFourBar linkage{{{0, 0}, {0, 2}, {4, 0}, {3, 2.8284271247461903}}, {1, 2}};

StrokeFigures figures() {
  StrokeFigures over;
  over.from = -1;
  over.to = 3;
  over.max_deviation = 0.1;
  over.min_transmission_angle = radians(50);
  over.drive = DriveOfStroke{2, 1, 3};
  return over;
}

TEST(LineWorth, IsThatOfItsLength) {
  const LineWorth worth = LineWorth::of(figures(), 0.2);
  EXPECT_EQ(worth.usable, 4);
  EXPECT_EQ(worth.deviation, 0.2);
  EXPECT_EQ(worth.min_transmission_angle, radians(50));
  EXPECT_EQ(worth.velocity_nonuniformity, 1);  // (3 − 1) over 4 / 2
}

TEST(LineWorth, HasNoEvenVelocityWhereTheInputTurnsBack) {
  StrokeFigures over = figures();
  over.drive = std::nullopt;
  EXPECT_EQ(LineWorth::of(over, 0).velocity_nonuniformity, infinity);
}

bool meets(const LineWorth& worth, const Requirements& wanted) {
  return CellJudge(wanted, straight_line_linkages, straight_line_measures).passes(line_cell(linkage, worth));
}
bool may_meet(const Requirements& wanted) {
  return CellJudge(wanted, straight_line_linkages, straight_line_measures)
      .may_pass(line_cell(linkage, LineWorth::unknown()));
}

TEST(LineWorth, MeetsEachRequirementUpToItsLimit) {
  const LineWorth worth = LineWorth::of(figures(), 0.2);
  Requirements wanted;
  EXPECT_TRUE(meets(worth, wanted));
  wanted.min_stroke = 4;
  wanted.max_deviation = 0.2;
  wanted.min_transmission_angle = radians(50);
  EXPECT_TRUE(meets(worth, wanted));
  Requirements longer = wanted, straighter = wanted, steeper = wanted;
  longer.min_stroke = 4.1;
  straighter.max_deviation = 0.19;
  steeper.min_transmission_angle = radians(51);
  for (const Requirements& more : {longer, straighter, steeper}) {
    EXPECT_FALSE(meets(worth, more));
    EXPECT_TRUE(may_meet(more));
  }
}

TEST(LineWorth, OfAStrokeThatIsNotReachedMeetsNoRequirements) {
  const LineWorth worth = LineWorth::of(figures(), infinity);
  Requirements wanted;
  EXPECT_FALSE(meets(worth, wanted));
  wanted.max_deviation = 1e300;
  EXPECT_FALSE(meets(worth, wanted));
}

TEST(LineWorth, OfALinkageAsItLies) {
  Requirements wanted;
  wanted.max_length = 4.3;
  wanted.types = {linkage_type(linkage.bars.lengths())};
  wanted.max_link_ratio = 4.3;
  wanted.ground_pivots_within = Box{0, 4, 0, 0};
  wanted.moving_pivots_within = Box{0, 3, 2, 3};
  EXPECT_TRUE(may_meet(wanted));
  Requirements of_type = wanted, of_ratio = wanted, of_length = wanted, of_ground = wanted, of_moving = wanted;
  of_type.types = {LinkageType::change_point};
  of_ratio.max_link_ratio = 3.9;
  of_length.max_length = 3.9;
  of_ground.ground_pivots_within = Box{0, 3.9, 0, 0};
  of_moving.moving_pivots_within = Box{0, 3, 2, 2.8};
  for (const Requirements& more : {of_type, of_ratio, of_length, of_ground, of_moving}) EXPECT_FALSE(may_meet(more));
}

TEST(LineWorth, RanksByTheLengthOverTheLongestLinkAndByEachNumber) {
  const Cell cell = line_cell(linkage, LineWorth::of(figures(), 0.2));
  const auto score = [&](Objective objective) { return rank_of(objective, straight_line_measures).score(cell); };
  EXPECT_DOUBLE_EQ(score(Objective::stroke), 4 / linkage.longest());
  EXPECT_EQ(score(Objective::deviation), -0.2);
  EXPECT_EQ(score(Objective::size), -linkage.longest());
  EXPECT_EQ(score(Objective::velocity_uniformity), -1);
  EXPECT_DOUBLE_EQ(score(Objective::min_transmission_angle), versine_of_angle(radians(50)));
}

}  // namespace
}  // namespace linkwright
