#include "linkwright/attitude/point_motion.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/attitude/euler_rates.hpp"
#include "support/attitude_case.hpp"
#include "support/central_difference.hpp"
#include "support/group_laws.hpp"

namespace linkwright::point_motion_test {
namespace {

using testing::random_direction;
using testing::ulps_between;

BodyMotion random_body(std::mt19937_64& random) {
  const auto v = [&random] { return random_direction(random); };
  return {Rotation(testing::random_rotation(random)), {v(), v()}, {v(), v(), v()}};
}

double ulps(const PointMotion& a, const PointMotion& b) {
  return std::max({ulps_between(a.position, b.position), ulps_between(a.velocity, b.velocity),
                   ulps_between(a.acceleration, b.acceleration)});
}

double ulps(const BodyMotion& a, const BodyMotion& b) {
  return std::max({ulps_between(a.attitude, b.attitude), ulps_between(a.angular.velocity, b.angular.velocity),
                   ulps_between(a.angular.acceleration, b.angular.acceleration), ulps(a.origin, b.origin)});
}

/// A body that tumbles and flies, and a point that swings in it: as functions of time, and their exact derivatives.
EulerAngles angles_at(double t) {
  return {EulerSequence::euler_313(), 0.3 + 1.1 * t, 1.0 + 0.4 * t - 0.3 * t * t, -0.5 + 2 * t};
}
EulerRates rates_at(double t) { return {{1.1, 0.4 - 0.6 * t, 2}, {0, -0.6, 0}}; }
PointMotion flight_at(double t) {
  return {{3 * t, -1 + t * t, std::sin(t)}, {3, 2 * t, std::cos(t)}, {0, 2, -std::sin(t)}};
}
PointMotion swing_at(double t) {
  return {{std::cos(2 * t), 0.5, t}, {-2 * std::sin(2 * t), 0, 1}, {-4 * std::cos(2 * t), 0, 0}};
}
BodyMotion body_at(double t) {
  return {angles_at(t).rotation(), angular_motion(angles_at(t), rates_at(t)), flight_at(t)};
}

TEST(PointMotion, AboutAFixedPointIsThatOfTheMatrices) {
  const AngularMotion m{{1, 2, 3}, {-4, 5, 6}};
  const PointMotion p = motion_about_fixed_point(m, {7, 8, -9});
  EXPECT_EQ(p.velocity, angular_velocity_matrix(m.velocity) * p.position);
  EXPECT_EQ(p.acceleration, angular_acceleration_matrix(m) * p.position);
}

TEST(PointMotion, OnATurntableHasItsTextbookAcceleration) {
  // Walking outwards at 2 on a table that turns at 3: 18 inwards at radius 2, 12 sideways.
  const BodyMotion table{Rotation(), {{0, 0, 3}, {}}, {}};
  const PointMotion walker{{2, 0, 0}, {2, 0, 0}, {}};
  const AccelerationParts parts = acceleration_parts(table, walker);
  EXPECT_EQ(parts.centripetal, (Vector3{-18, 0, 0}));
  EXPECT_EQ(parts.coriolis, (Vector3{0, 12, 0}));
  EXPECT_EQ(parts.sum(), (Vector3{-18, 12, 0}));
  EXPECT_EQ(point_motion(table, walker).velocity, (Vector3{2, 6, 0}));
}

TEST(PointMotion, InGeneralMotionIsTheDerivativeOfThePosition) {
  for (double t = -1; t < 1; t += 0.13) {
    const auto fixed = [](double s) { return body_at(s).pose().apply_to_point({0.2, -0.7, 1}); };
    const auto moving = [](double s) { return body_at(s).pose().apply_to_point(swing_at(s).position); };
    const PointMotion stays = point_motion(body_at(t), Vector3{0.2, -0.7, 1});
    const PointMotion swings = point_motion(body_at(t), swing_at(t));
    EXPECT_LE(norm(stays.velocity - testing::first_difference(fixed, t, 0.01)), 1e-10);
    EXPECT_LE(norm(stays.acceleration - testing::second_difference(fixed, t, 0.01)), 1e-9);
    EXPECT_LE(norm(swings.velocity - testing::first_difference(moving, t, 0.01)), 1e-9);
    EXPECT_LE(norm(swings.acceleration - testing::second_difference(moving, t, 0.01)), 1e-8);
  }
}

TEST(PointMotion, OfTheOriginOfTheBodyIsThatOfTheOrigin) {
  std::mt19937_64 random(1);
  const BodyMotion body = random_body(random);
  EXPECT_LE(ulps(point_motion(body, Vector3{}), body.origin), 0);
}

TEST(PointMotion, MotionsOfBodiesAreAGroup) {
  const testing::Group<BodyMotion> motions{random_body, [](const BodyMotion& m) { return inverse(m); },
                                           [](const BodyMotion& a, const BodyMotion& b) { return ulps(a, b); }};
  testing::expect_group_laws(motions, 60);
  testing::expect_action_laws<BodyMotion, PointMotion>(
      motions, [](const BodyMotion& m, const PointMotion& p) { return point_motion(m, p); },
      [](std::mt19937_64& random) {
        return PointMotion{random_direction(random), random_direction(random), random_direction(random)};
      },
      [](const PointMotion& a, const PointMotion& b) { return ulps(a, b); }, 60);
}

}  // namespace
}  // namespace linkwright::point_motion_test
