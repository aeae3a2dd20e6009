#include "linkwright/analysis/driver_order.hpp"

#include <gtest/gtest.h>

namespace linkwright::driver_order_test {
namespace {

// A body that turns about the origin: a circle point on it meets the poses where they are.
std::vector<PrescribedPose> turns(const std::vector<double>& angles) {
  std::vector<PrescribedPose> poses;
  for (const double angle : angles) poses.push_back({{{}, angle}, {}});
  return poses;
}

DriverOrder order_of(const std::vector<double>& angles) { return driver_order({0, 0}, {1, 0}, turns(angles), true); }

TEST(DriverOrder, OneWayWithinOneTurn) {
  const DriverOrder up = order_of({0, 1, 2, 5});
  EXPECT_TRUE(up.ccw);
  EXPECT_FALSE(up.cw);
  EXPECT_NEAR(up.sweep_ccw, 5, 1e-12);
  EXPECT_TRUE(up.is_wide_ccw());
  EXPECT_FALSE(up.is_wide_cw());
  const DriverOrder down = order_of({0, -1, -2, -5});
  EXPECT_FALSE(down.ccw);
  EXPECT_TRUE(down.cw);
  EXPECT_NEAR(down.sweep_cw(), 5, 1e-12);
}

TEST(DriverOrder, MoreThanATurnOrBackAndForthIsNoOrder) {
  EXPECT_FALSE(order_of({0, 3, 6, 9}).ccw);
  const DriverOrder mixed = order_of({0, 2, 1, 3});
  EXPECT_FALSE(mixed.ccw);
  EXPECT_FALSE(mixed.cw);
}

TEST(DriverOrder, TwoPosesAreInOrderBothWaysAndOneIsToo) {
  const DriverOrder two = order_of({0, 1});
  EXPECT_TRUE(two.ccw && two.cw);
  const DriverOrder one = order_of({0.4});
  EXPECT_TRUE(one.ccw && one.cw);
  EXPECT_EQ(one.sweep_ccw, 0);
  EXPECT_FALSE(one.is_wide_ccw() || one.is_wide_cw());
}

TEST(DriverOrder, ThreePosesAreAlwaysInOrderOneWay) {
  for (const double second : {0.5, 2.0, 4.0})
    for (const double third : {0.7, 3.0, 6.0}) {
      const DriverOrder order = order_of({0, second, third});
      EXPECT_NE(order.ccw, order.cw) << second << " " << third;
    }
}

TEST(DriverOrder, RepeatedDirectionIsNoOrder) {
  const DriverOrder same = order_of({0, 1, 1, 2});
  EXPECT_FALSE(same.ccw || same.cw);
}

TEST(DriverOrder, DirectionOfTravelCounts) {
  auto poses = turns({0, 1});
  poses[0].derivatives = {{{0, 0}, -1}};  // the body turns clockwise there
  EXPECT_FALSE(driver_order({0, 0}, {1, 0}, poses, true).ccw);
  EXPECT_TRUE(driver_order({0, 0}, {1, 0}, poses, true).cw);
  EXPECT_TRUE(driver_order({0, 0}, {1, 0}, poses, false).ccw);
  poses[0].derivatives = {{{1, 0}, 0}};  // along the arm: a dead point, in neither sense
  const DriverOrder dead = driver_order({0, 0}, {1, 0}, poses, true);
  EXPECT_FALSE(dead.ccw || dead.cw);
}

}  // namespace
}  // namespace linkwright::driver_order_test
