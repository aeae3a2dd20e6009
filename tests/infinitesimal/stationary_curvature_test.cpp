#include "linkwright/infinitesimal/stationary_curvature.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/infinitesimal/line_contact.hpp"
#include "support/circle_contact.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright::stationary_curvature_test {
namespace {

const FourBar some{{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}};
MotionSeries motion_of(const FourBar& bars) { return coupler_motion(bars, *loop_series(bars)); }
TurningInstant instant_at(const FourBar& bars) { return std::get<TurningInstant>(*instant_of(motion_of(bars))); }

TEST(StationaryCurvature, PairsHaveFourPointContactAndPivotsAreAmongThem) {
  const MotionSeries motion = motion_of(some);
  const TurningInstant instant = instant_at(some);
  for (double angle = 0.1; angle < pi; angle += 0.2) {
    const CurvaturePair pair = stationary_pair(instant, angle);
    const auto moving = finite_point(pair.moving), center = finite_point(pair.center);
    ASSERT_TRUE(moving && center);
    EXPECT_GE(testing::contact_with_circle(motion, *moving, *center), 4) << angle;
  }
  const Point local = instant.to_canonical(some.input_moving);
  const CurvaturePair pair = stationary_pair(instant, std::arg(local));
  EXPECT_NEAR(std::abs(*finite_point(pair.moving) - some.input_moving), 0, 1e-12);
  EXPECT_NEAR(std::abs(*finite_point(pair.center) - some.input_fixed), 0, 1e-11);
}

TEST(StationaryCurvature, ConjugateCentersAreThoseOfThePaths) {
  const MotionSeries motion = motion_of(some);
  const TurningInstant instant = instant_at(some);
  for (const double angle : {0.3, 1.2, 2.8})
    for (const double distance : {-3.0, 0.5, 2.0}) {
      const Point point = instant.to_fixed(distance * direction(angle));
      const auto by_euler = finite_point(conjugate_center(instant, angle, distance)),
                 by_path = finite_point(*center_of_curvature(motion, point));
      EXPECT_NEAR(std::abs(*by_euler - *by_path), 0, 1e-11);
    }
}

TEST(StationaryCurvature, BallsPointIsThatOfTheCases) {
  for (const auto& known : testing::straight_line_cases()) {
    if (!known.json.contains("instant") || known.json.at("instant").at("ball").is_null()) continue;
    SCOPED_TRACE(known.name);
    const auto ball = ball_point(instant_at(known.four_bar));
    ASSERT_TRUE(ball);
    const auto& expected = known.json.at("instant").at("ball");
    EXPECT_NEAR(std::abs(*ball - Point{expected.at(0), expected.at(1)}), 0, 1e-9 * known.four_bar.lengths().longest());
    const MotionSeries motion = motion_of(known.four_bar);
    const Point velocity = motion.path_of(*ball).c[1];
    EXPECT_GE(contact_with_line(motion, *ball, velocity / std::abs(velocity)).points, 4);
  }
}

// Crank in line with the coupler: the cubic meets the inflection circle at the pole only.
TEST(StationaryCurvature, ACrankInLineWithItsCouplerHasBallsPointAtThePole) {
  const FourBar bars{{0, 0}, {1, 0}, {2.5, -1.5}, {3, 0}};
  const TurningInstant instant = instant_at(bars);
  EXPECT_NEAR(std::abs(instant.pole - bars.output_moving), 0, 1e-13);
  EXPECT_NEAR(instant.a3, 0, 1e-12);
  const auto ball = ball_point(instant);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(std::abs(*ball - instant.pole), 0, 1e-12);
}

TEST(StationaryCurvature, BurmesterPointsHaveFivePointContactAndHoldThePivots) {
  int extra = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto at = [&](int k) { return Point{std::sin(1.7 * trial + k), std::cos(2.3 * trial + 1.9 * k)}; };
    const FourBar bars{3.0 * at(1), 2.0 * at(2), 3.0 * at(3), 2.0 * at(4)};
    const auto loop = loop_series(bars);
    if (!loop) continue;
    const TurningInstant instant = instant_at(bars);
    const auto points = burmester_points_at(instant);
    EXPECT_LE(points.size(), 4U);
    for (const Point pivot : {bars.input_moving, bars.output_moving}) {
      double nearest = 1e9;
      for (const CurvaturePair& pair : points)
        if (const auto moving = finite_point(pair.moving)) nearest = std::min(nearest, std::abs(*moving - pivot));
      EXPECT_LT(nearest, 1e-6) << trial;
    }
    extra += points.size() == 4;
  }
  EXPECT_GT(extra, 30);
}

// Coupler parallel to the frame: the cubic is the pole normal and a circle, and points of both are found.
TEST(StationaryCurvature, BurmesterPointsOfASymmetricLinkageLieSymmetrically) {
  const FourBar bars{{-2, 0}, {-1, 1.5}, {2, 0}, {1, 1.5}};
  const TurningInstant instant = instant_at(bars);
  EXPECT_NEAR(instant.n(), 0, 1e-14);
  const auto points = burmester_points_at(instant);
  const MotionSeries motion = motion_of(bars);
  double sum = 0;
  int on_normal = 0;
  for (const CurvaturePair& pair : points) {
    const Point moving = *finite_point(pair.moving);
    EXPECT_GE(testing::contact_with_circle(motion, moving, *finite_point(pair.center)), 5);
    sum += moving.real();
    on_normal += std::abs(moving.real()) < 1e-9;
  }
  EXPECT_NEAR(sum, 0, 1e-9);
  EXPECT_EQ(points.size(), 4U);
  EXPECT_EQ(on_normal, 2);
}

}  // namespace
}  // namespace linkwright::stationary_curvature_test
