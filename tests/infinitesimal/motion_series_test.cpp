#include "linkwright/infinitesimal/motion_series.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright::motion_series_test {
namespace {

const FourBar some{{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}};
// Input link and coupler in one line: a dead point of the output, none of the input's.
const FourBar in_line{{0, 0}, {1, 0}, {2.5, -1.5}, {3, 0}};

TEST(MotionSeries, LinksKeepTheirLengthsAlongTheSeries) {
  for (const FourBar& bars : {some, some.swapped(), in_line, in_line.swapped()}) {
    const auto loop = loop_series(bars);
    ASSERT_TRUE(loop);
    const MotionSeries motion = coupler_motion(bars, *loop);
    for (const double t : {-0.02, 0.01, 0.02}) {
      const Point input = motion.path_of(bars.input_moving)(t), output = motion.path_of(bars.output_moving)(t);
      EXPECT_NEAR(std::abs(input - bars.input_fixed), bars.lengths().input, 1e-11);
      EXPECT_NEAR(std::abs(output - input), bars.lengths().coupler, 1e-11);
      EXPECT_NEAR(std::abs(output - bars.output_fixed), bars.lengths().output, 1e-11);
    }
  }
}

TEST(MotionSeries, FirstTwoTurnsAreVelocityAnalysis) {
  const auto loop = loop_series(some);
  const auto rates = angle_rates(some.lengths(), configuration_of(some));
  ASSERT_TRUE(loop && rates);
  const auto by_input = composed(loop->coupler, inverse(loop->input));
  EXPECT_NEAR(by_input.c[1], rates->coupler, 1e-14);
  EXPECT_NEAR(2 * by_input.c[2], rates->coupler_acceleration, 1e-13);
}

TEST(MotionSeries, TheInputTurnsCounterClockwise) {
  EXPECT_GT(loop_series(some)->input.c[1], 0);
  EXPECT_GT(loop_series(some.swapped())->input.c[1], 0);
  EXPECT_NEAR(loop_series(in_line.swapped())->input.c[1], 0, 1e-15);
  EXPECT_GT(loop_series(in_line.swapped())->coupler.c[1], 0);
}

TEST(MotionSeries, LinksInOneLineHaveNone) {
  EXPECT_FALSE(loop_series({{0, 0}, {1, 0}, {4, 0}, {3, 0}}));
  EXPECT_FALSE(loop_series({{0, 0}, {2, 1}, {8, 4}, {-4, -2}}));
}

TEST(MotionSeries, ByItsTurnItIsTheSameMotion) {
  const MotionSeries motion = coupler_motion(some, *loop_series(some));
  const auto by_turn = motion.by_turn();
  ASSERT_TRUE(by_turn);
  constexpr double t = 0.01;
  const Point traced{2, 5}, there = motion.path_of(traced)(t);
  EXPECT_NEAR(std::abs(by_turn->path_of(traced)(motion.turn(t)) - there), 0, 1e-12);
  const FourBar parallelogram{{0, 0}, {1, 2}, {4, 0}, {5, 2}};
  EXPECT_FALSE(coupler_motion(parallelogram, *loop_series(parallelogram)).by_turn());
}

TEST(MotionSeries, PrescribedOneHasItsDerivatives) {
  const PrescribedPose pose{{{3, 4}, 0.7}, {{{1, 2}, 0.5}, {{-1, 0.5}, 0.25}, {{0.1, 0.2}, -0.3}}};
  const MotionSeries motion = prescribed_motion(pose);
  EXPECT_EQ(motion.order, 3U);
  for (std::size_t k = 1; k <= 3; ++k) {
    EXPECT_EQ(motion.path.derivative(k), pose.derivatives[k - 1].origin);
    EXPECT_DOUBLE_EQ(motion.turn.derivative(k), pose.derivatives[k - 1].angle);
  }
}

}  // namespace
}  // namespace linkwright::motion_series_test
