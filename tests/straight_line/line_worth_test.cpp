#include "linkwright/straight_line/line_worth.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

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

TEST(LineWorth, MeetsEachRequirementUpToItsLimit) {
  const LineWorth worth = LineWorth::of(figures(), 0.2);
  Requirements wanted;
  EXPECT_TRUE(meets(worth, wanted));
  wanted.min_stroke = 4;
  wanted.max_deviation = 0.2;
  wanted.min_transmission_angle = radians(50);
  EXPECT_TRUE(meets(worth, wanted));
  const auto fails_with = [&](const Requirements& more, RequirementKind kind) {
    return !meets(worth, more) && !meets(kind, worth, more);
  };
  Requirements longer = wanted, straighter = wanted, steeper = wanted;
  longer.min_stroke = 4.1;
  straighter.max_deviation = 0.19;
  steeper.min_transmission_angle = radians(51);
  EXPECT_TRUE(fails_with(longer, RequirementKind::min_stroke));
  EXPECT_TRUE(fails_with(straighter, RequirementKind::max_deviation));
  EXPECT_TRUE(fails_with(steeper, RequirementKind::min_transmission_angle));
}

TEST(LineWorth, OfAStrokeThatIsNotReachedMeetsNoRequirements) {
  const LineWorth worth = LineWorth::of(figures(), infinity);
  Requirements wanted;
  EXPECT_FALSE(meets(worth, wanted));
  EXPECT_FALSE(meets(RequirementKind::max_deviation, worth, wanted));
  wanted.max_deviation = 1e300;
  EXPECT_FALSE(meets(worth, wanted));
}

TEST(LineWorth, OfALinkageAsItLies) {
  Requirements wanted;
  wanted.max_length = 4.3;
  EXPECT_TRUE(has_shape(linkage, wanted));
  EXPECT_TRUE(has_place(linkage, wanted));
  wanted.types = {linkage_type(linkage.bars.lengths())};
  wanted.max_link_ratio = 4.3;
  wanted.ground_pivots_within = Box{0, 4, 0, 0};
  wanted.moving_pivots_within = Box{0, 3, 2, 3};
  EXPECT_TRUE(has_shape(linkage, wanted));
  EXPECT_TRUE(has_place(linkage, wanted));
  Requirements of_type = wanted, of_ratio = wanted, of_length = wanted, of_ground = wanted, of_moving = wanted;
  of_type.types = {LinkageType::change_point};
  of_ratio.max_link_ratio = 3.9;
  of_length.max_length = 3.9;
  of_ground.ground_pivots_within = Box{0, 3.9, 0, 0};
  of_moving.moving_pivots_within = Box{0, 3, 2, 2.8};
  EXPECT_FALSE(has_shape(linkage, of_type));
  EXPECT_FALSE(has_shape(linkage, of_ratio));
  EXPECT_FALSE(has_place(linkage, of_length));
  EXPECT_FALSE(has_place(linkage, of_ground));
  EXPECT_FALSE(has_place(linkage, of_moving));
  EXPECT_FALSE(meets(RequirementKind::types, linkage, of_type));
  EXPECT_TRUE(meets(RequirementKind::min_stroke, linkage, of_type));
}

TEST(LineWorth, RanksByTheLengthOverTheLongestLinkAndByEachNumber) {
  const LineWorth worth = LineWorth::of(figures(), 0.2);
  EXPECT_DOUBLE_EQ(score_of(Objective::stroke, linkage, worth), 4 / linkage.longest());
  EXPECT_EQ(score_of(Objective::deviation, linkage, worth), -0.2);
  EXPECT_EQ(score_of(Objective::size, linkage, worth), -linkage.longest());
  EXPECT_EQ(score_of(Objective::velocity_uniformity, linkage, worth), -1);
  EXPECT_DOUBLE_EQ(score_of(Objective::min_transmission_angle, linkage, worth), versine_of_angle(radians(50)));
}

}  // namespace
}  // namespace linkwright
