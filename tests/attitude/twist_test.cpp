#include "linkwright/attitude/twist.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

#include "linkwright/attitude/point_motion.hpp"
#include "linkwright/attitude/screw.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::twist_test {
namespace {

using testing::random_direction;
using testing::ulps_between;

constexpr double infinity = std::numeric_limits<double>::infinity();

InstantaneousScrew screw(const Twist& twist) {
  const auto result = instantaneous_screw(twist);
  EXPECT_TRUE(result.ok());
  return result ? *result : InstantaneousScrew{};
}

Twist random_twist(std::mt19937_64& random) {
  std::uniform_real_distribution<double> speed(0.1, 3);
  return {speed(random) * random_direction(random), speed(random) * random_direction(random)};
}

TEST(Twist, GivesTheVelocityOfAnyPoint) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 omega = random_direction(random), v = random_direction(random), r = 2.0 * random_direction(random),
                  other = random_direction(random);
    const Twist twist = Twist::of_point(omega, v, r);
    EXPECT_LE(ulps_between(twist.velocity_at(r), v), 8);
    const BodyMotion body{Rotation(), {omega, {}}, {{}, twist.velocity, {}}};
    EXPECT_LE(ulps_between(twist.velocity_at(other), point_motion(body, other).velocity), 8);
  }
}

TEST(Twist, IsTheLimitOfTheFiniteScrew) {
  // A body turns at a constant ω about a line that moves: its poses at −½dt and ½dt have a finite screw whose rates
  // differ from the instantaneous ones by dt².
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    const Vector3 omega = (0.5 + 0.01 * i) * random_direction(random), p0 = random_direction(random),
                  v = random_direction(random), a = random_direction(random);
    const auto pose = [&](double t) {
      return Displacement{*Rotation::about_axis(omega, norm(omega) * t), p0 + t * v + 0.5 * t * t * a};
    };
    const InstantaneousScrew limit = screw(Twist::of_point(omega, v, p0));
    double errors[2];
    const double steps[2] = {2e-3, 1e-3};
    for (int k = 0; k < 2; ++k) {
      const double dt = steps[k];
      const auto finite = screw_of(pose(dt / 2) * pose(-dt / 2).inverse());
      ASSERT_TRUE(finite.ok());
      const double pitch_error = std::fabs(*finite->pitch() - *limit.pitch());
      errors[k] = std::max({norm(finite->direction - limit.direction), norm(finite->point - limit.point),
                            std::fabs(finite->angle / dt - limit.rate),
                            std::fabs(finite->translation / dt - limit.slide_rate), pitch_error});
    }
    EXPECT_LE(errors[1], 1e-5);
    EXPECT_LE(errors[1], 0.27 * errors[0] + 1e-9) << "of second order";
  }
}

TEST(Twist, ComesBackFromItsScrew) {
  std::mt19937_64 random(3);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Twist given = random_twist(random);
    const InstantaneousScrew s = screw(given);
    const auto again = twist_of(s);
    ASSERT_TRUE(again.ok());
    worst =
        std::max({worst, ulps_between(again->angular, given.angular), ulps_between(again->velocity, given.velocity)});
    EXPECT_LE(std::fabs(dot(s.point, s.direction)), 1e-15 * (1 + norm(s.point))) << "the point nearest the origin";
    EXPECT_NEAR(*s.pitch(), dot(given.angular, given.velocity) / dot(given.angular, given.angular), 1e-13);
  }
  EXPECT_LE(worst, 16);
}

TEST(Twist, PointsOfTheAxisSlideAlongIt) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Twist twist = random_twist(random);
    const InstantaneousScrew s = screw(twist);
    const double size = 1 + norm(s.point) * s.rate;
    EXPECT_LE(norm(twist.velocity_at(s.point + 0.7 * s.direction) - s.slide_rate * s.direction), 4e-15 * size);
    const Vector3 off = cross(s.direction, random_direction(random));
    EXPECT_GE(norm(twist.velocity_at(s.point + off)), std::fabs(s.slide_rate) - 4e-15 * size) << "nothing is slower";
  }
}

TEST(Twist, GoesWithTheFrame) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Twist in_j = random_twist(random);
    const Displacement frame{Rotation(testing::random_rotation(random)), random_direction(random)};
    const InstantaneousScrew j = screw(in_j),
                             i_ = screw(Twist::of_point(frame.apply_to_direction(in_j.angular),
                                                        frame.apply_to_direction(in_j.velocity), frame.translation));
    EXPECT_NEAR(*i_.pitch(), *j.pitch(), 1e-12);
    EXPECT_LE(norm(i_.direction - frame.apply_to_direction(j.direction)), 4e-15);
    EXPECT_LE(norm(cross(frame.apply_to_point(j.point) - i_.point, i_.direction)), 1e-13 * (1 + norm(j.point)));
  }
}

TEST(Twist, HasFourKinds) {
  EXPECT_EQ(screw({}).kind, TwistKind::rest);
  EXPECT_EQ(screw({}).pitch(), std::nullopt);

  const InstantaneousScrew sliding = screw({{}, {0, 3, 4}});
  EXPECT_EQ(sliding.kind, TwistKind::translation);
  EXPECT_EQ(sliding.slide_rate, 5);
  EXPECT_EQ(sliding.point, Vector3{});
  EXPECT_EQ(sliding.pitch(), std::nullopt);

  const InstantaneousScrew turning = screw({{0, 0, 2}, {0, -6, 0}});
  EXPECT_EQ(turning.kind, TwistKind::rotation);
  EXPECT_EQ(turning.point, (Vector3{3, 0, 0}));
  EXPECT_EQ(turning.pitch(), 0);

  const InstantaneousScrew both = screw({{0, 0, 2}, {0, -6, -1}});
  EXPECT_EQ(both.kind, TwistKind::screw);
  EXPECT_EQ(both.slide_rate, -1);
  EXPECT_EQ(both.pitch(), -0.5);
}

TEST(Twist, ARotationAnywhereIsNamedSo) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 10000; ++i) {
    const auto twist = twist_of(random_direction(random), random_direction(random), 1 + 0.001 * i, 0);
    ASSERT_EQ(screw(*twist).kind, TwistKind::rotation);
  }
}

TEST(Twist, RefusesWhatIsNone) {
  const auto code = [](const auto& result) { return result ? std::string("none") : result.errors().front().code; };
  EXPECT_EQ(code(twist_of({0, 0, 0}, {1, 2, 3}, 1, 1)), "zero_axis");
  EXPECT_EQ(code(twist_of({0, 0, 1}, {1, infinity, 3}, 1, 1)), "not_finite");
  EXPECT_EQ(code(twist_of({0, 0, 1}, {1, 0, 0}, infinity, 1)), "not_finite");
  EXPECT_EQ(code(twist_of({0, 0, 1}, {1e308, 0, 0}, 1e10, 0)), "not_finite") << "overflow";
  EXPECT_EQ(code(instantaneous_screw({{0, 0, 1}, {infinity, 0, 0}})), "not_finite");
  EXPECT_EQ(code(instantaneous_screw({{0, 0, 1e-300}, {1e200, 0, 0}})), "axis_too_far");
}

}  // namespace
}  // namespace linkwright::twist_test
