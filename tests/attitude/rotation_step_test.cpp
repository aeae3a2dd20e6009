#include "attitude/rotation_step.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/attitude/euler_rates.hpp"
#include "linkwright/attitude/rotation.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::rotation_step_test {
namespace {

constexpr int million = 1000000;

TEST(RotationStep, WithConstantVelocityIsExact) {
  const Result<Rotation> expected = Rotation::about_axis({1, 2, 2}, 0.75);
  const Result<UnitQuaternion> q = rotation_step(UnitQuaternion(), {0.5, 1, 1}, 0.5);
  EXPECT_LE(testing::ulps_between(Rotation(*q), *expected), 2);
  EXPECT_EQ(*rotation_step(*q, {}, 1), *q);
  EXPECT_LE(testing::ulps_between(*rotation_step(*q, {0.5, 1, 1}, -0.5), UnitQuaternion()), 1);
}

TEST(RotationStep, TurnsAboutAxesOfTheFixedFrame) {
  const Rotation c = Rotation::about_x(1);
  const Result<Rotation> stepped = rotation_step(c, {0, 0, 0.3}, 1);
  EXPECT_LE(testing::ulps_between(*stepped, Rotation::about_z(0.3) * c), 3);
}

TEST(RotationStep, AMillionOfThemStayARotationAndReachTheAttitude) {
  const Vector3 omega{0.3, -0.7, 1.1};
  const double dt = 0x1p-10;
  UnitQuaternion q;
  for (int i = 0; i < million; ++i) q = *rotation_step(q, omega, dt);
  const double length_error = std::fabs(q.w() * q.w() + dot(q.v(), q.v()) - 1);
  EXPECT_LE(length_error, 4 * testing::ulp);
  EXPECT_LE(orthogonality_error(q.matrix()), 8 * testing::ulp);
  const Result<Rotation> exact = Rotation::about_axis(omega, norm(omega) * million * dt);
  const double drift = angle_between(Rotation(q), *exact);
  EXPECT_LE(drift, 5e-12) << "rounding of a million steps";
  RecordProperty("drift_in_1e-16_rad", std::to_string(drift * 1e16));
}

TEST(RotationStep, AMillionOfMatricesStayARotationToo) {
  const double dt = 0x1p-10;
  Rotation c = Rotation::about_y(0.4), product = c;
  const Rotation step = *rotation_step(Rotation(), {0.3, -0.7, 1.1}, dt);
  for (int i = 0; i < million; ++i) {
    c = *rotation_step(c, {0.3, -0.7, 1.1}, dt);
    product = step * product;
  }
  EXPECT_LE(orthogonality_error(c.matrix()), 8 * testing::ulp);
  EXPECT_GT(orthogonality_error(product.matrix()), 1000 * testing::ulp) << "what bare products do";
  EXPECT_LE(angle_between(c, product), 1e-9);
}

/// A motion whose attitude and angular velocity are known at every time.
EulerAngles angles_at(double t) {
  return {EulerSequence::euler_313(), 0.3 + t + 0.2 * t * t, 1 + 0.5 * std::sin(t), -0.4 + 1.5 * t};
}
Vector3 omega_at(double t) {
  return angular_motion(angles_at(t), EulerRates{{1 + 0.4 * t, 0.5 * std::cos(t), 1.5}, {}}).velocity;
}

double midpoint_error(int steps) {
  UnitQuaternion q = angles_at(0).quaternion();
  const double dt = 2.0 / steps;
  for (int i = 0; i < steps; ++i) q = *rotation_step(q, omega_at((i + 0.5) * dt), dt);
  return angle_between(q, angles_at(2).quaternion());
}

double gauss_error(int steps) {
  UnitQuaternion q = angles_at(0).quaternion();
  const double dt = 2.0 / steps;
  for (int i = 0; i < steps; ++i)
    q = *gauss_step(q, {omega_at((i + gauss_shares[0]) * dt), omega_at((i + gauss_shares[1]) * dt)}, dt);
  return angle_between(q, angles_at(2).quaternion());
}

TEST(RotationStep, AtTheMiddleOfTheStepIsOfOrderTwo) {
  for (const int steps : {50, 100, 200}) {
    const double ratio = midpoint_error(steps) / midpoint_error(2 * steps);
    EXPECT_NEAR(ratio, 4, 0.1) << steps;
  }
}

TEST(RotationStep, AtTheGaussPointsIsOfOrderFour) {
  for (const int steps : {25, 50, 100}) {
    const double ratio = gauss_error(steps) / gauss_error(2 * steps);
    EXPECT_NEAR(ratio, 16, 0.8) << steps;
  }
  EXPECT_LT(gauss_error(100), 2e-8);
}

TEST(RotationStep, RefusesWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rotation_step(UnitQuaternion(), {nan, 0, 0}, 1).errors().front().code, "not_finite");
  EXPECT_EQ(rotation_step(Rotation(), {1, 0, 0}, nan).errors().front().code, "not_finite");
  EXPECT_EQ(rotation_step(UnitQuaternion(), {1e300, 0, 0}, 1e300).errors().front().code, "not_finite");
  EXPECT_EQ(gauss_step(UnitQuaternion(), {Vector3{nan, 0, 0}, Vector3{}}, 1).errors().front().code, "not_finite");
}

}  // namespace
}  // namespace linkwright::rotation_step_test
