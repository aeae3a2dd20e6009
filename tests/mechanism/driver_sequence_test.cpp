#include "linkwright/mechanism/driver_sequence.hpp"

#include <gtest/gtest.h>

namespace linkwright::driver_sequence_test {
namespace {

// A body that turns about the origin: a circle point on it meets the poses where they are.
std::vector<PrescribedPose> turns(const std::vector<double>& angles) {
  std::vector<PrescribedPose> poses;
  for (const double angle : angles) poses.push_back({{{}, angle}, {}});
  return poses;
}

DriverSequence order_of(const std::vector<double>& angles) {
  return driver_sequence({0, 0}, {1, 0}, turns(angles), true);
}

TEST(DriverSequence, OneWayWithinOneTurn) {
  const DriverSequence up = order_of({0, 1, 2, 5});
  EXPECT_TRUE(up.ccw);
  EXPECT_FALSE(up.cw);
  EXPECT_NEAR(up.sweep_ccw, 5, 1e-12);
  EXPECT_TRUE(up.is_at_least_half_turn_ccw());
  EXPECT_FALSE(up.is_at_least_half_turn_cw());
  const DriverSequence down = order_of({0, -1, -2, -5});
  EXPECT_FALSE(down.ccw);
  EXPECT_TRUE(down.cw);
  EXPECT_NEAR(down.sweep_cw(), 5, 1e-12);
}

TEST(DriverSequence, MoreThanATurnOrBackAndForthIsNoOrder) {
  EXPECT_FALSE(order_of({0, 3, 6, 9}).ccw);
  const DriverSequence mixed = order_of({0, 2, 1, 3});
  EXPECT_FALSE(mixed.ccw);
  EXPECT_FALSE(mixed.cw);
}

TEST(DriverSequence, TwoPosesAreInOrderBothWaysAndOneIsToo) {
  const DriverSequence two = order_of({0, 1});
  EXPECT_TRUE(two.ccw && two.cw);
  const DriverSequence one = order_of({0.4});
  EXPECT_TRUE(one.ccw && one.cw);
  EXPECT_EQ(one.sweep_ccw, 0);
  EXPECT_FALSE(one.is_at_least_half_turn_ccw() || one.is_at_least_half_turn_cw());
}

TEST(DriverSequence, ThreePosesAreAlwaysInOrderOneWay) {
  for (const double second : {0.5, 2.0, 4.0})
    for (const double third : {0.7, 3.0, 6.0}) {
      const DriverSequence order = order_of({0, second, third});
      EXPECT_NE(order.ccw, order.cw) << second << " " << third;
    }
}

TEST(DriverSequence, RepeatedDirectionIsNoOrder) {
  const DriverSequence same = order_of({0, 1, 1, 2});
  EXPECT_FALSE(same.ccw || same.cw);
}

TEST(DriverSequence, DirectionOfTravelCounts) {
  auto poses = turns({0, 1});
  poses[0].derivatives = {{{0, 0}, -1}};  // the body turns clockwise there
  EXPECT_FALSE(driver_sequence({0, 0}, {1, 0}, poses, true).ccw);
  EXPECT_TRUE(driver_sequence({0, 0}, {1, 0}, poses, true).cw);
  EXPECT_TRUE(driver_sequence({0, 0}, {1, 0}, poses, false).ccw);
  poses[0].derivatives = {{{1, 0}, 0}};  // along the arm: a dead point, in neither sense
  const DriverSequence dead = driver_sequence({0, 0}, {1, 0}, poses, true);
  EXPECT_FALSE(dead.ccw || dead.cw);
}

}  // namespace
}  // namespace linkwright::driver_sequence_test
