#include "linkwright/core/angle.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace linkwright::angle_test {
namespace {

TEST(Angle, DegreesAndRadiansAreInverse) {
  for (const double deg : {-720.0, -90.0, 0.0, 1e-9, 57.0, 180.0, 359.0})
    EXPECT_NEAR(degrees(radians(deg)), deg, 1e-13 * std::abs(deg));
  EXPECT_EQ(radians(180), pi);
  EXPECT_EQ(degrees(pi), 180);
}

TEST(Angle, WrapsDifferByWholeTurns) {
  for (double angle = -20; angle < 20; angle += 0.37) {
    const auto turns = [angle](double wrapped) { return (angle - wrapped) / two_pi; };
    EXPECT_NEAR(turns(wrap_positive(angle)), std::round(turns(wrap_positive(angle))), 1e-14);
    EXPECT_NEAR(turns(wrap_signed(angle)), std::round(turns(wrap_signed(angle))), 1e-14);
  }
}

TEST(Angle, WrapsKeepTheirHalfOpenRanges) {
  for (const double angle :
       {0.0, -0.0, 1e-300, -1e-300, -1e-17, pi, -pi, two_pi, -two_pi, 3 * pi, -3 * pi, 1e9, -1e9}) {
    EXPECT_GE(wrap_positive(angle), 0);
    EXPECT_LT(wrap_positive(angle), two_pi);
    EXPECT_GT(wrap_signed(angle), -pi);
    EXPECT_LE(wrap_signed(angle), pi);
  }
}

TEST(Angle, WrapSignedTakesMinusPiToPi) {
  EXPECT_EQ(wrap_signed(-pi), pi);
  EXPECT_EQ(wrap_signed(pi), pi);
}

TEST(Angle, WrapPeriodRunsRound) {
  EXPECT_DOUBLE_EQ(wrap_period(2.25, 2), 0.25);
  EXPECT_DOUBLE_EQ(wrap_period(-0.25, 2), 1.75);
  EXPECT_EQ(wrap_period(2, 2), 0);
  EXPECT_LT(wrap_period(-1e-18, 2), 2) << "never the period itself";
}

}  // namespace
}  // namespace linkwright::angle_test
