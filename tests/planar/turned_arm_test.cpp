#include "planar/turned_arm.hpp"

#include <array>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::turned_arm_test {
namespace {

// The angle of which these are the derivatives at t = 0.
constexpr std::array<double, 4> rates = {0.7, -1.3, 0.4, 2.1};

Point arm_at(double t) {
  return direction(0.4 + rates[0] * t + rates[1] * t * t / 2 + rates[2] * t * t * t / 6 +
                   rates[3] * t * t * t * t / 24) *
         Point{2, 1};
}

TEST(TurnedArm, HasTheDerivativesOfTheTurn) {
  const auto arm = turned_arm({2, 1}, 0.4, rates);
  ASSERT_EQ(arm.size(), 5u);
  constexpr double h = 1e-3;
  EXPECT_NEAR(std::abs(arm[0] - arm_at(0)), 0, 1e-15);
  EXPECT_NEAR(std::abs(arm[1] - (arm_at(h) - arm_at(-h)) / (2 * h)), 0, 1e-5);
  EXPECT_NEAR(std::abs(arm[2] - (arm_at(h) - 2.0 * arm_at(0) + arm_at(-h)) / (h * h)), 0, 1e-5);
  EXPECT_NEAR(
      std::abs(arm[3] - (arm_at(2 * h) - 2.0 * arm_at(h) + 2.0 * arm_at(-h) - arm_at(-2 * h)) / (2 * h * h * h)), 0,
      1e-4);
}

TEST(TurnedArm, GivesItsRatesBack) {
  const auto back = turn_rates(turned_arm({2, 1}, 0.4, rates));
  ASSERT_EQ(back.size(), rates.size());
  for (std::size_t m = 0; m < rates.size(); ++m) EXPECT_NEAR(back[m], rates[m], 1e-13);
  EXPECT_TRUE(turn_rates({Point{1, 0}}).empty());
  EXPECT_EQ(turn_rates({Point{}, Point{1, 1}}).front(), 0) << "an arm without length";
}

}  // namespace
}  // namespace linkwright::turned_arm_test
