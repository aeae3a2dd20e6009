#include "linkwright/infinitesimal/instant.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright::instant_test {
namespace {

MotionSeries motion_of(const FourBar& bars) { return coupler_motion(bars, *loop_series(bars)); }

TEST(Instant, IsThatOfTheCases) {
  int seen = 0;
  for (const auto& known : testing::straight_line_cases()) {
    SCOPED_TRACE(known.name);
    if (!known.json.contains("instant") || known.json.at("instant").is_null()) continue;
    const auto& expected = known.json.at("instant");
    const auto instant = instant_of(motion_of(known.four_bar));
    ASSERT_TRUE(instant);
    const auto* turning = std::get_if<TurningInstant>(&*instant);
    ASSERT_NE(turning, nullptr);
    ++seen;
    // With a negative diameter the case's axes point the other way.
    const double sign = expected.at("D").get<double>() < 0 ? -1 : 1, size = known.four_bar.lengths().longest();
    const auto number = [&](const char* key) {
      return expected.at(key).is_null() ? NAN : sign * expected.at(key).get<double>();
    };
    const auto near = [&](double value, double wanted) {
      EXPECT_NEAR(value, wanted, 1e-9 * (std::abs(wanted) + size));
    };
    near(turning->pole.real(), expected.at("P").at(0));
    near(turning->pole.imag(), expected.at("P").at(1));
    near(turning->diameter, number("D"));
    EXPECT_NEAR(std::abs(turning->tangent - sign * direction(expected.at("alpha_rad"))), 0, 1e-10);
    near(turning->m() * size, number("m") * size);
    near(turning->n() * size, number("n") * size);
    near(turning->a3, number("a3"));
    near(turning->b3, number("b3"));
    ASSERT_TRUE(turning->fourth);
    if (!expected.at("a4").is_null()) near(turning->fourth->a4, number("a4"));
    if (!expected.at("b4").is_null()) near(turning->fourth->b4, number("b4"));
    const Point pole{expected.at("inflection_pole").at(0), expected.at("inflection_pole").at(1)};
    EXPECT_NEAR(std::abs(turning->inflection_pole() - pole), 0, 1e-9 * size);
  }
  EXPECT_GT(seen, 15);
}

TEST(Instant, SideLinksAreThePathsCurvatures) {
  const FourBar bars{{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}};
  const MotionSeries motion = motion_of(bars);
  const auto center = finite_point(*center_of_curvature(motion, bars.output_moving));
  ASSERT_TRUE(center);
  EXPECT_NEAR(std::abs(*center - bars.output_fixed), 0, 1e-13);
  const auto instant = std::get<TurningInstant>(*instant_of(motion));
  EXPECT_TRUE(is_at_infinity(normalized(*center_of_curvature(motion, instant.inflection_pole()))));
  EXPECT_FALSE(center_of_curvature(motion_of({{0, 0}, {1, 1}, {4, 0}, {3, 1}}), {2, 2}));
}

TEST(Instant, GoessnersFourBarHasItsInflectionPole) {
  const FourBar bars{{0, 0}, {0.5, 0.8660254037844386}, {3.5, 0}, {3.042852921295991, 2.4578479506333157}};
  const auto instant = std::get<TurningInstant>(*instant_of(motion_of(bars)));
  EXPECT_NEAR(std::abs(instant.pole - Point{2.647198327716059, 4.58508200131558}), 0, 1e-12);
  EXPECT_NEAR(std::abs(instant.inflection_pole() - Point{-26.36712311218636, -4.917039453444595}), 0, 1e-11);
  EXPECT_NEAR(instant.diameter, 30.530659356767824, 1e-11);
}

// A circle that rolls without sliding, by its own turn: in one twice as large, and on a straight rail.
TEST(Instant, RollingCirclesHaveTheirTextbookInflectionCircles) {
  const PrescribedPose cardan{{{1, 0}, 0}, {{{0, -1}, 1}, {{-1, 0}, 0}, {{0, 1}, 0}}};
  const auto inside = std::get<TurningInstant>(*instant_of(prescribed_motion(cardan)));
  EXPECT_NEAR(std::abs(inside.pole - Point{2, 0}), 0, 1e-15);
  EXPECT_NEAR(inside.diameter, 2, 1e-15);
  EXPECT_NEAR(std::abs(inside.inflection_circle().center - Point{1, 0}), 0, 1e-15);
  EXPECT_FALSE(inside.fourth);
  const PrescribedPose wheel{{{0, 1}, 0}, {{{-1, 0}, 1}, {{0, 0}, 0}, {{0, 0}, 0}}};
  const auto rolling = std::get<TurningInstant>(*instant_of(prescribed_motion(wheel)));
  EXPECT_NEAR(std::abs(rolling.pole), 0, 1e-15);
  EXPECT_NEAR(std::abs(rolling.inflection_pole() - Point{0, 1}), 0, 1e-15);
}

TEST(Instant, ParallelSideLinksTranslate) {
  const FourBar bars{{0, 0}, {0, 1}, {3, 4}, {3, 1.5}};  // ρ = 1, and 2.5 to the other side
  const auto instant = instant_of(motion_of(bars));
  const auto* translating = std::get_if<TranslatingInstant>(&*instant);
  ASSERT_NE(translating, nullptr);
  const auto line = translating->inflection_line();
  ASSERT_TRUE(line);
  EXPECT_NEAR(dot(line->direction, translating->velocity), 0, 1e-15);
  // κ is linear along the velocity, 1 at x = 0 and −1 / 2.5 at x = 3.
  EXPECT_NEAR(line->point.real(), 3 / 1.4, 1e-14);
  EXPECT_NEAR(std::abs(translating->slope), 1.4 / 3, 1e-14);
  const FourBar parallelogram{{0, 0}, {1, 2}, {4, 0}, {5, 2}};
  EXPECT_FALSE(std::get<TranslatingInstant>(*instant_of(motion_of(parallelogram))).inflection_line());
}

TEST(Instant, APivotedBodyHasNoInflectionCircle) {
  const PrescribedPose pivoted{{{1, 0}, 0}, {{{0, 1}, 1}, {{-1, 0}, 0}, {{0, -1}, 0}}};
  const auto instant = instant_of(prescribed_motion(pivoted));
  ASSERT_TRUE(instant && std::holds_alternative<PivotingInstant>(*instant));
  EXPECT_NEAR(std::abs(std::get<PivotingInstant>(*instant).pole), 0, 1e-15);
  const PrescribedPose at_rest{{{1, 0}, 0}, {{0, 0}, {{-1, 0}, 1}, {{0, -1}, 0}}};
  EXPECT_FALSE(instant_of(prescribed_motion(at_rest)));
}

// The accelerations of the body's points, by differences over time.
TEST(Instant, AccelerationPoleAndBresseCircleAreWhatTimeShows) {
  const FourBar bars{{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}};
  const MotionSeries motion = motion_of(bars);
  const auto instant = std::get<TurningInstant>(*instant_of(motion));
  constexpr double velocity = 1.5, acceleration = -0.8;
  RealSeries<motion_order> in_time;
  in_time.c = {0, velocity, acceleration / 2};
  MotionSeries timed = *motion.by_turn();
  timed.path = composed(timed.path, in_time);
  timed.turn = in_time;
  const auto pole = acceleration_pole(timed);
  ASSERT_TRUE(pole);
  EXPECT_NEAR(std::abs(timed.path_of(*pole).derivative(2)), 0, 1e-12);
  EXPECT_NEAR(std::abs(*pole - instant.inflection_circle().center), instant.diameter / 2, 1e-12);
  const auto circle = std::get<Circle>(*bresse_circle(instant, timed));
  for (double angle = 0; angle < two_pi; angle += 0.4) {
    const auto path = timed.path_of(circle.center + circle.radius * direction(angle));
    EXPECT_NEAR(dot(path.derivative(1), path.derivative(2)), 0, 1e-10);
  }
  const auto even = std::get<StraightLine>(*bresse_circle(instant, *motion.by_turn()));
  EXPECT_NEAR(dot(even.direction, instant.tangent), 0, 1e-15);
}

TEST(Instant, BressesCircleOfATranslationIsALine) {
  const FourBar bars{{0, 0}, {0, 1}, {3, 4}, {3, 1.5}};
  const MotionSeries motion = motion_of(bars);
  const auto line = std::get<StraightLine>(*bresse_circle(*instant_of(motion), motion));
  for (const double way : {-2.0, 0.0, 5.0}) {
    const auto path = motion.path_of(line.point + way * line.direction);
    EXPECT_NEAR(dot(path.derivative(1), path.derivative(2)), 0, 1e-12);
  }
  EXPECT_FALSE(bresse_circle(PivotingInstant{}, motion));
}

}  // namespace
}  // namespace linkwright::instant_test
