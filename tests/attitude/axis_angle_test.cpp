#include "linkwright/attitude/axis_angle.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::axis_angle_test {
namespace {

using testing::attitude_cases;
using testing::random_direction;
using testing::random_rotation;
using testing::ulp;
using testing::ulps_between;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

AxisAngle turn(Vector3 axis, double angle) { return AxisAngle::of(axis, angle).value(); }

TEST(AxisAngle, IsThatOfTheTableFromTheQuaternion) {
  for (const auto& c : attitude_cases()) {
    const AxisAngle found = AxisAngle::of(c.input);
    EXPECT_NEAR(found.angle(), c.angle, 4 * ulp * c.angle) << c.name << ": relatively exact";
    EXPECT_EQ(found.axis_defined(), c.axis.has_value()) << c.name;
    EXPECT_LE(ulps_between(found.axis(), c.axis.value_or(Vector3{0, 0, 1})), 2) << c.name;
  }
}

TEST(AxisAngle, IsThatOfTheTableFromTheMatrix) {
  for (const auto& c : attitude_cases()) {
    const AxisAngle found = AxisAngle::of(Rotation::from_matrix(c.matrix).value());
    EXPECT_NEAR(found.angle(), c.angle, 4 * ulp * std::min(c.angle, 1.0)) << c.name;
    EXPECT_EQ(found.axis_defined(), c.axis.has_value()) << c.name;
    // Nearer to a half-turn than the matrix can tell, the sign of the axis is the canonical one.
    const Vector3 axis = c.axis.value_or(Vector3{0, 0, 1});
    const double sign = c.w < ulp && dot(axis, found.axis()) < 0 ? -1 : 1;
    EXPECT_LE(ulps_between(found.axis(), sign * axis), 4) << c.name;
  }
}

TEST(AxisAngle, ComesBackFromTheMatrixForEveryAngle) {
  std::mt19937_64 random(1);
  for (double exponent = 0; exponent < 100; exponent += 0.05)
    for (const double angle : {std::pow(10, -exponent), pi - std::pow(10, -exponent)}) {
      const Vector3 axis = random_direction(random);
      const AxisAngle found = AxisAngle::of(turn(axis, angle).rotation());
      EXPECT_NEAR(found.angle(), angle, 4 * ulp * std::min(angle, 1.0)) << angle;
      const double sign = pi - angle < 4 * ulp && dot(axis, found.axis()) < 0 ? -1 : 1;
      EXPECT_LE(ulps_between(found.axis(), sign * axis), 4) << angle;
    }
}

TEST(AxisAngle, AngleIsInZeroToPi) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 10'000; ++n) {
    const AxisAngle found = AxisAngle::of(random_rotation(random));
    EXPECT_GE(found.angle(), 0);
    EXPECT_LE(found.angle(), pi);
  }
  EXPECT_NEAR(AxisAngle::of(turn({0, 1, 0}, 3 * pi / 2).rotation()).angle(), pi / 2, 4 * ulp);
  EXPECT_LE(ulps_between(AxisAngle::of(turn({0, 1, 0}, 3 * pi / 2).rotation()).axis(), {0, -1, 0}), 1);
}

TEST(AxisAngle, OfAHalfTurnHasTheCanonicalSign) {
  const Matrix3x3 about_x{{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}}, about_z{{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}};
  EXPECT_EQ(AxisAngle::of(Rotation::from_matrix(about_x).value()).axis(), (Vector3{1, 0, 0}));
  EXPECT_EQ(AxisAngle::of(Rotation::from_matrix(about_z).value()).axis(), (Vector3{0, 0, 1}));
  EXPECT_EQ(AxisAngle::of(Rotation::from_matrix(about_z).value()).angle(), pi);
  const AxisAngle oblique = AxisAngle::of(*UnitQuaternion::of(0, {0, -3, 4}));
  EXPECT_LE(ulps_between(oblique.axis(), {0, 0.6, -0.8}), 1);
}

TEST(AxisAngle, OfTheIdentityHasNoAxis) {
  EXPECT_FALSE(AxisAngle::of(Rotation()).axis_defined());
  EXPECT_EQ(AxisAngle::of(Rotation()).axis(), (Vector3{0, 0, 1}));
  EXPECT_EQ(AxisAngle::of(Rotation()).angle(), 0);
  EXPECT_TRUE(turn({1, 0, 0}, 0).axis_defined()) << "it was given";
}

TEST(AxisAngle, KeepsTheAngleAndNormalizesTheAxis) {
  EXPECT_EQ(turn({0, 3e-310, 0}, -7).axis(), (Vector3{0, 1, 0}));
  EXPECT_EQ(turn({0, 3, 0}, -7).angle(), -7);
  EXPECT_LE(ulps_between(turn({1, 2, 3}, 0.5).rotation(), turn({1, 2, 3}, 0.5 + 2 * two_pi).rotation()), 12);
}

TEST(AxisAngle, RefusesNoAxisAndWhatIsNotANumber) {
  EXPECT_EQ(AxisAngle::of({}, 1).errors().front().code, "zero_axis");
  EXPECT_EQ(AxisAngle::of({0, nan, 0}, 1).errors().front().place, "axis");
  EXPECT_EQ(AxisAngle::of({0, 1, 0}, nan).errors().front().place, "angle");
  EXPECT_EQ(AxisAngle::of({0, 1, 0}, -infinity).errors().front().code, "not_finite");
}

}  // namespace
}  // namespace linkwright::axis_angle_test
