#include "linkwright/attitude/quaternion_rate.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/attitude/euler_rates.hpp"
#include "support/attitude_case.hpp"
#include "support/central_difference.hpp"

namespace linkwright::quaternion_rate_test {
namespace {

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
}  // namespace linkwright::quaternion_rate_test
