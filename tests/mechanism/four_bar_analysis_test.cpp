#include "linkwright/mechanism/four_bar_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::four_bar_analysis_test {
namespace {

// Ground 4, input 2, coupler 3, output 3.5, the input at right angles to the ground link.
FourBar crank_rocker() {
  const Point moving{0, 2}, far{4, 0};
  const Point between = far - moving;
  const double along = (std::norm(between) + 9 - 12.25) / (2 * std::abs(between));
  const Point unit = between / std::abs(between);
  return {0, moving, far, moving + unit * Point{along, std::sqrt(9 - along * along)}};
}

TEST(FourBarAnalysis, OfACrankIsThatOfItsFullTurn) {
  const FourBarAnalysis found = analyze(crank_rocker(), {1, 1});
  EXPECT_EQ(found.type, LinkageType::crank_rocker);
  EXPECT_TRUE(found.dead_points.empty());
  ASSERT_EQ(found.motion.size(), 361u);
  double least = pi;
  for (const MotionState& state : found.motion) least = std::min(least, state.transmission_angle);
  EXPECT_NEAR(found.min_transmission_angle_full_turn, least, 1e-3);
  EXPECT_LE(found.min_transmission_angle_full_turn, least + 1e-12);
}

TEST(FourBarAnalysis, LinksKeepTheirLengthsInEveryState) {
  const FourBar bars = crank_rocker();
  for (const MotionState& state : tabulated_motion(bars, {1, 1})) {
    EXPECT_NEAR(state.four_bar.lengths().coupler, bars.lengths().coupler, 1e-9);
    EXPECT_NEAR(state.four_bar.lengths().output, bars.lengths().output, 1e-9);
    EXPECT_NEAR(std::abs(state.coupler_point - state.four_bar.input_moving), std::abs(Point(1, 1) - bars.input_moving),
                1e-9);
  }
}

TEST(FourBarAnalysis, OfARockerEndsAtItsDeadPoints) {
  const FourBarAnalysis found = analyze(crank_rocker().swapped(), {1, 1});
  EXPECT_EQ(found.type, LinkageType::rocker_crank);
  ASSERT_EQ(found.input_ranges.size(), 2u);
  EXPECT_EQ(found.min_transmission_angle_full_turn, 0);
  ASSERT_FALSE(found.motion.empty());
  EXPECT_NEAR(found.motion.front().transmission_angle, 0, 1e-6);
  for (const DeadPoint& dead_point : found.dead_points)
    EXPECT_TRUE(std::any_of(found.input_ranges.begin(), found.input_ranges.end(), [&](const AngleRange& range) {
      const double angle = dead_point.configuration.input_angle;
      return std::abs(wrap_signed(angle - range.from)) < 1e-9 || std::abs(wrap_signed(angle - range.to)) < 1e-9;
    }));
}

}  // namespace
}  // namespace linkwright::four_bar_analysis_test
