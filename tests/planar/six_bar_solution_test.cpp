#include "linkwright/planar/six_bar_solution.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_solution_test {
namespace {

TEST(SixBarSolution, IsCheckedInTheUsersCoordinates) {
  std::mt19937_64 random(41);
  int free_ones = 0;
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 6; ++i) {
      const auto [task, member] = testing::random_six_bar(random, row);
      const SixBarSolution solution = solution_of(task.poses, task.chain, row, member);
      EXPECT_EQ(member.six_bar.topology(), row.topology);
      EXPECT_EQ(solution.lengths.size(), 10u);
      EXPECT_LT(solution.residual, 1e-10);
      EXPECT_LT(solution.pose_residual, 1e-12);
      const SixBarRating quick = rating_of(member, true);
      EXPECT_EQ(quick.drive.defects, solution.rating.drive.defects);
      if (!solution.rating.drive.defects.none() || solution.rating.drive.min_sine < 0.05) continue;
      ++free_ones;
      EXPECT_TRUE(solution.verified_by_driving) << text(row.added[0]) << text(row.added[1]) << i;
    }
  EXPECT_GT(free_ones, 10);
}

TEST(SixBarSolution, OfAnotherBodyIsNotVerified) {
  std::mt19937_64 random(42);
  for (const SixBarRow& row : six_bar_rows()) {
    auto [task, member] = testing::random_six_bar(random, row);
    task.poses[2].pose.origin += Point{0, 0.01};
    const SixBarSolution solution = solution_of(task.poses, task.chain, row, member);
    EXPECT_GT(solution.pose_residual, 1e-4);
    if (solution.rating.drive.defects.none()) {
      EXPECT_FALSE(solution.verified_by_driving);
    }
  }
}

TEST(SixBarSolution, MeasuresItsShape) {
  const SixBar six_bar = SixBar::of({Point{0, 0}, Point{0, 1}, Point{3, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                                    {Point{4, 0}, Point{4, 3}}, {Point{9, -4}, Point{8, 3}});
  const SixBarShape shape = shape_of(six_bar);
  EXPECT_DOUBLE_EQ(shape.longest, std::abs(Point{9, -4}));
  EXPECT_DOUBLE_EQ(shape.link_ratio, std::abs(Point{9, -4}));
  EXPECT_EQ(shape.type, LinkageType::crank_rocker);
  SixBar without_crank = six_bar;
  without_crank.joints[SixBar::b].point = 0;
  EXPECT_EQ(shape_of(without_crank).type, LinkageType::degenerate);
  EXPECT_EQ(SixBarRating{shape_of(without_crank)}.cell().type, LinkageType::degenerate);
}

TEST(SixBarSolution, MeetsRequirementsOrNot) {
  const SixBar six_bar = SixBar::of({Point{0, 0}, Point{0, 1}, Point{3, 2}}, {BodyPair{0, 2}, BodyPair{0, 3}},
                                    {Point{4, 0}, Point{4, 3}}, {Point{9, -4}, Point{8, 3}});
  SixBarRating rating{shape_of(six_bar)};
  rating.drive.completed = true;
  rating.drive.min_sine = 0.5;
  Requirements wanted;
  EXPECT_TRUE(meets(wanted, six_bar, rating));
  EXPECT_NEAR(rating.min_transmission_angle(), radians(30), 1e-12);
  EXPECT_NEAR(rating.versine(), 1 - std::cos(radians(30)), 1e-12);
  wanted.min_transmission_angle = radians(31);
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.max_length = 9;
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.max_link_ratio = 5;
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.types = {LinkageType::double_crank};
  EXPECT_FALSE(meets(wanted, six_bar, rating));
  wanted = {};
  wanted.ground_pivots_within = Box{-1, 9, -5, 1};
  EXPECT_TRUE(meets(wanted, six_bar, rating));
  wanted.moving_pivots_within = Box{-1, 5, -5, 5};
  EXPECT_FALSE(meets(wanted, six_bar, rating)) << "z5 lies outside";
  rating.drive.defects.bits = Defects::order_bit;
  EXPECT_FALSE(meets({}, six_bar, rating));
}

TEST(SixBarSolution, TakesItsLongestLinkFromTheChain) {
  const ThreeLinkChain chain{{0, 0}, {0, 3}, {4, 3}, {}};
  EXPECT_DOUBLE_EQ(with_defaults(Requirements{}, chain).max_length.value_or(0), 50);
  Requirements wanted;
  wanted.max_length = 7;
  EXPECT_DOUBLE_EQ(with_defaults(wanted, chain).max_length.value_or(0), 7);
}

}  // namespace
}  // namespace linkwright::six_bar_solution_test
