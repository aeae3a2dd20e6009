#include "linkwright/attitude/angular_motion.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/attitude/euler_rates.hpp"
#include "support/attitude_case.hpp"
#include "support/central_difference.hpp"

namespace linkwright::angular_motion_test {
namespace {

using testing::random_direction;
using testing::ulps_between;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

AngularMotion random_motion(std::mt19937_64& random) { return {random_direction(random), random_direction(random)}; }

TEST(AngularMotion, MatricesOfVelocityAndAccelerationAreThoseOfTheCrossProducts) {
  const AngularMotion m{{1, 2, 3}, {-4, 5, 6}};
  const Vector3 r{7, 8, -9};
  EXPECT_EQ(angular_velocity_matrix(m.velocity) * r, cross(m.velocity, r));
  EXPECT_EQ(angular_acceleration_matrix(m) * r, cross(m.acceleration, r) + cross(m.velocity, cross(m.velocity, r)));
}

TEST(AngularMotion, ComesBackFromTheDerivatives) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const Rotation c(testing::random_rotation(random));
    const AngularMotion given = random_motion(random);
    const Result<AngularMotionFit> fit = angular_motion(c, rotation_derivatives(c, given));
    ASSERT_TRUE(fit.ok());
    worst = std::max({worst, ulps_between(fit->in_i.velocity, given.velocity),
                      ulps_between(fit->in_i.acceleration, given.acceleration)});
    EXPECT_LE(ulps_between(c.apply(fit->in_j.velocity), given.velocity), 8);
    EXPECT_LE(ulps_between(c.apply(fit->in_j.acceleration), given.acceleration), 8);
    EXPECT_LE(fit->velocity_defect, 8 * testing::ulp);
    EXPECT_LE(fit->acceleration_defect, 12 * testing::ulp);
  }
  EXPECT_LE(worst, 4);
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST(AngularMotion, InTheMovingFrameBelongsToTheProductsFromTheOtherSide) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    const Rotation c(testing::random_rotation(random));
    const RotationDerivatives d = rotation_derivatives(c, random_motion(random));
    const Result<AngularMotionFit> fit = angular_motion(c, d);
    const Matrix3x3 transpose = transposed(c.matrix());
    EXPECT_LE(ulps_between(transpose * d.first, angular_velocity_matrix(fit->in_j.velocity)), 6);
    EXPECT_LE(ulps_between(transpose * d.second, angular_acceleration_matrix(fit->in_j)), 8);
  }
}

TEST(AngularMotion, KeepsSmallAndLargeRates) {
  for (const double size : {1e-150, 1e-12, 1e12, 1e150}) {
    const AngularMotion given{{size, -2 * size, 3 * size}, {}};
    const Rotation c = Rotation::about_x(0.4);
    const Result<AngularMotionFit> fit = angular_velocity(c, rotation_derivatives(c, given).first);
    ASSERT_TRUE(fit.ok());
    EXPECT_LE(norm(fit->in_i.velocity - given.velocity), 2e-15 * size);
  }
  EXPECT_EQ(angular_motion(Rotation(), {})->in_i.velocity, Vector3{}) << "at rest";
}

TEST(AngularMotion, LeavesOutTheSymmetricPartAndTellsIt) {
  const Rotation c = Rotation::about_y(0.7);
  const Vector3 omega{0.3, -0.2, 0.9};
  RotationDerivatives d = rotation_derivatives(c, {omega, {}});
  const Matrix3x3 stretch{{{{0.01, 0, 0}, {0, -0.02, 0}, {0, 0, 0.02}}}};
  d.first = d.first + stretch * c.matrix();
  const Result<AngularMotionFit> refused = angular_velocity(c, d.first);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.errors().front().code, "not_a_derivative");
  EXPECT_NE(refused.errors().front().message.find("0.03 of"), std::string::npos) << refused.errors().front().message;
  const Result<AngularMotionFit> fit = angular_velocity(c, d.first, 1);
  ASSERT_TRUE(fit.ok());
  EXPECT_LE(ulps_between(fit->in_i.velocity, omega), 2);
  EXPECT_NEAR(fit->velocity_defect, 0.03, 1e-15);
}

TEST(AngularMotion, RefusesASecondDerivativeThatDoesNotBelong) {
  const Rotation c = Rotation::about_y(0.7);
  RotationDerivatives d = rotation_derivatives(c, {{1, 2, 3}, {4, 5, 6}});
  d.second = {};
  const Result<AngularMotionFit> fit = angular_motion(c, d);
  ASSERT_FALSE(fit.ok());
  EXPECT_EQ(fit.errors().front().place, "second");
  EXPECT_TRUE(angular_motion(c, d, 1).ok());
}

TEST(AngularMotion, RefusesWhatIsNotANumber) {
  Matrix3x3 bad;
  bad(1, 2) = nan;
  EXPECT_EQ(angular_velocity(Rotation(), bad).errors().front().code, "not_finite");
  EXPECT_EQ(angular_motion(Rotation(), {{}, bad}).errors().front().code, "not_finite");
  EXPECT_EQ(angular_motion(Rotation(), {bad, {}}).errors().front().code, "not_finite");
}

TEST(AngularMotion, OfACarriedFrameIsThatOfTheProductOfTheMatrices) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Rotation c_ij(testing::random_rotation(random)), c_jk(testing::random_rotation(random));
    const AngularMotion ij = random_motion(random), jk = random_motion(random);
    const RotationDerivatives a = rotation_derivatives(c_ij, ij), b = rotation_derivatives(c_jk, jk);
    const Matrix3x3 first = a.first * c_jk.matrix() + c_ij.matrix() * b.first;
    const Matrix3x3 second = a.second * c_jk.matrix() + 2.0 * (a.first * b.first) + c_ij.matrix() * b.second;
    const Result<AngularMotionFit> ik = angular_motion(c_ij * c_jk, {first, second});
    ASSERT_TRUE(ik.ok());
    const AngularMotion expected = composed(ij, c_ij, jk);
    EXPECT_LE(ulps_between(ik->in_i.velocity, expected.velocity), 10);
    EXPECT_LE(ulps_between(ik->in_i.acceleration, expected.acceleration), 20);
  }
}

using testing::random_direction;
using testing::ulps_between;

TEST(QuaternionRate, OfATurnAboutZ) {
  const Result<UnitQuaternion> q = UnitQuaternion::of(0.8, {0, 0, 0.6});
  const QuaternionRate rate = quaternion_rate(*q, {0, 0, 2});
  EXPECT_DOUBLE_EQ(rate.w, -0.6);
  EXPECT_LE(ulps_between(rate.v, {0, 0, 0.8}), 1);
}

TEST(QuaternionRate, ComesBackAsAngularMotion) {
  std::mt19937_64 random(1);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const UnitQuaternion q = testing::random_rotation(random);
    const AngularMotion given{random_direction(random), random_direction(random)};
    const Result<QuaternionRateFit> fit =
        angular_motion(q, quaternion_rate(q, given.velocity), quaternion_acceleration(q, given));
    ASSERT_TRUE(fit.ok());
    worst = std::max({worst, ulps_between(fit->in_i.velocity, given.velocity),
                      ulps_between(fit->in_i.acceleration, given.acceleration)});
    EXPECT_LE(fit->velocity_defect, 4 * testing::ulp);
    EXPECT_LE(fit->acceleration_defect, 4 * testing::ulp);
  }
  EXPECT_LE(worst, 4);
  RecordProperty("worst_ulps", std::to_string(worst));
}

TEST(QuaternionRate, IsTheDerivativeOfTheQuaternion) {
  const auto angles = [](double t) {
    return EulerAngles{EulerSequence::cardan_123(), 0.2 + t, 0.3 - 0.5 * t * t, 2 * t};
  };
  const auto w = [&](double t) { return angles(t).quaternion().w(); };
  const auto v = [&](double t) { return angles(t).quaternion().v(); };
  for (double t = -0.6; t < 0.6; t += 0.1) {
    const UnitQuaternion q = angles(t).quaternion();
    const AngularMotion motion = angular_motion(angles(t), EulerRates{{1, -t, 2}, {0, -1, 0}});
    const QuaternionRate first = quaternion_rate(q, motion.velocity), second = quaternion_acceleration(q, motion);
    EXPECT_NEAR(first.w, testing::first_difference(w, t, 0.01), 1e-11);
    EXPECT_LE(norm(first.v - testing::first_difference(v, t, 0.01)), 1e-11);
    EXPECT_NEAR(second.w, testing::second_difference(w, t, 0.01), 1e-10);
    EXPECT_LE(norm(second.v - testing::second_difference(v, t, 0.01)), 1e-10);
  }
}

TEST(QuaternionRate, TellsWhatWouldChangeTheLength) {
  std::mt19937_64 random(2);
  const UnitQuaternion q = testing::random_rotation(random);
  QuaternionRate rate = quaternion_rate(q, {1, 2, 3});
  rate = {rate.w + 0.1 * q.w(), rate.v + 0.1 * q.v()};
  const Result<QuaternionRateFit> fit = angular_velocity(q, rate);
  EXPECT_LE(ulps_between(fit->in_i.velocity, {1, 2, 3}), 8);
  EXPECT_NEAR(fit->velocity_defect, 0.2, 1e-15);
}

TEST(QuaternionRate, RefusesWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(angular_velocity(UnitQuaternion(), {nan, {}}).ok());
  EXPECT_FALSE(angular_motion(UnitQuaternion(), {0, {0, nan, 0}}, {}).ok());
  EXPECT_FALSE(angular_motion(UnitQuaternion(), {}, {0, {0, nan, 0}}).ok());
}

}  // namespace
}  // namespace linkwright::angular_motion_test
