#include "linkwright/analysis/coupler_curve.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/analysis/transmission_angle.hpp"
#include "linkwright/core/angle.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::coupler_curve_test {
namespace {

using testing::four_bar_at;
using testing::RandomFourBars;

constexpr LinkLengths crank_rocker{4, 1, 3, 2.5}, rocker_crank{4, 2.5, 3, 1}, triple_rocker{3, 2, 2.2, 2.1};

// All that a state says must be so: the bars keep their lengths, and the traced point lies where it lies on the
// coupler.
void expect_states_of(const FourBar& four_bar, Point traced, const std::vector<MotionState>& states) {
  const LinkLengths wanted = four_bar.lengths();
  const auto on_coupler = [](const FourBar& f, Point p) {
    return (p - f.input_circle) / (f.output_circle - f.input_circle);
  };
  for (const MotionState& state : states) {
    const LinkLengths l = state.four_bar.lengths();
    ASSERT_NEAR(l.input, wanted.input, 1e-13);
    ASSERT_NEAR(l.coupler, wanted.coupler, 1e-13);
    ASSERT_NEAR(l.output, wanted.output, 1e-13);
    ASSERT_LT(std::abs(on_coupler(state.four_bar, state.coupler_point) - on_coupler(four_bar, traced)), 1e-11);
    ASSERT_NEAR(transmission_angle(l, state.configuration), state.transmission_angle, 1e-15);
  }
}

double distance(const MotionState& a, const MotionState& b) {
  return std::max({std::abs(a.four_bar.input_circle - b.four_bar.input_circle),
                   std::abs(a.four_bar.output_circle - b.four_bar.output_circle),
                   std::abs(a.coupler_point - b.coupler_point)});
}

TEST(MotionCycle, OfACrankIsOneTurnFromThePresentAngle) {
  const FourBar four_bar = four_bar_at(crank_rocker, 0.8, Assembly::negative);
  const Point traced{1, 2};
  const auto states = motion_cycle(four_bar, traced, 73);
  ASSERT_EQ(states.size(), 73u);
  expect_states_of(four_bar, traced, states);
  EXPECT_LT(std::abs(states[0].coupler_point - traced), 1e-14);
  EXPECT_NEAR(states[0].configuration.input_angle, 0.8, 1e-15);
  EXPECT_NEAR(states[1].configuration.input_angle, 0.8 + two_pi / 72, 1e-14) << "counter-clockwise";
  EXPECT_LT(distance(states.front(), states.back()), 1e-13);
  for (const MotionState& state : states) EXPECT_EQ(assembly_of(state.four_bar), Assembly::negative);
}

TEST(MotionCycle, OfARockerIsTheWholeCircuitFromDeadPointToDeadPointAndBack) {
  for (const LinkLengths& lengths : {rocker_crank, triple_rocker}) {
    const FourBar four_bar = four_bar_at(lengths, 0.8, Assembly::positive);
    const auto states = motion_cycle(four_bar, {1, 2}, 50);
    ASSERT_EQ(states.size(), 99u);
    expect_states_of(four_bar, {1, 2}, states);
    EXPECT_LT(distance(states.front(), states.back()), 1e-12);
    for (std::size_t i = 1; i < 49; ++i) {
      EXPECT_EQ(assembly_of(states[i].four_bar), Assembly::positive);
      EXPECT_EQ(assembly_of(states[98 - i].four_bar), Assembly::negative);
      EXPECT_NEAR(states[i].configuration.input_angle, states[98 - i].configuration.input_angle, 1e-14);
      EXPECT_TRUE(states[i].rates.has_value());
    }
    for (const std::size_t dead : {0, 49, 98}) {
      EXPECT_FALSE(states[dead].rates.has_value());
      EXPECT_NEAR(states[dead].transmission_angle, 0, 1e-15);
    }
  }
}

TEST(MotionCycle, ClosesAndStaysInItsCircuitForAnyLinkage) {
  RandomFourBars random(41);
  for (int i = 0; i < 1000; ++i) {
    const FourBar four_bar = random.four_bar();
    const Point traced{random.uniform(-3, 3), random.uniform(-3, 3)};
    const auto states = motion_cycle(four_bar, traced, 200);
    const bool crank = input_is_crank(linkage_type(four_bar.lengths()));
    ASSERT_EQ(states.size(), crank ? 200u : 399u);
    expect_states_of(four_bar, traced, states);
    ASSERT_FALSE(HasFatalFailure()) << "linkage " << i;
    EXPECT_LT(distance(states.front(), states.back()), 1e-10);
    const auto nearest = std::min_element(states.begin(), states.end(), [&](const auto& a, const auto& b) {
      return std::abs(a.coupler_point - traced) < std::abs(b.coupler_point - traced);
    });
    EXPECT_LT(std::abs(nearest->coupler_point - traced), 1.5) << "it passes the place where it started";
  }
}

TEST(MotionCycle, HasAnglesThatDoNotJump) {
  for (const LinkLengths& lengths : {crank_rocker, LinkLengths{1, 2, 3.5, 4}, triple_rocker}) {
    const auto states = motion_cycle(four_bar_at(lengths, 0.8, Assembly::positive), {}, 400);
    for (std::size_t i = 1; i < states.size(); ++i) {
      const Configuration &a = states[i - 1].configuration, &b = states[i].configuration;
      EXPECT_LT(std::abs(b.coupler_angle - a.coupler_angle), 0.3);
      EXPECT_LT(std::abs(b.output_angle - a.output_angle), 0.3);
    }
  }
}

TEST(MotionCycle, MovesTheDrawingAsItLies) {
  RandomFourBars random(42);
  const FourBar f = four_bar_at(crank_rocker, 0.8, Assembly::positive);
  const Point traced{1, 2};
  const auto states = motion_cycle(f, traced, 20);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const Point turn = scale * direction(random.uniform(-pi, pi)), shift = scale * Point{5, -7};
    const auto move = [&](Point p) { return turn * p + shift; };
    const auto again = motion_cycle(
        {move(f.input_center), move(f.input_circle), move(f.output_center), move(f.output_circle)}, move(traced), 20);
    ASSERT_EQ(again.size(), states.size());
    for (std::size_t i = 0; i < states.size(); ++i)
      EXPECT_LT(std::abs(again[i].coupler_point - move(states[i].coupler_point)), 1e-13 * scale);
  }
}

TEST(MotionSweep, TurnsTheInputAsFarAsAsked) {
  for (const double sweep : {0.5, -0.5}) {
    const FourBar four_bar = four_bar_at(triple_rocker, 0.8, Assembly::negative);
    const auto states = motion_sweep(four_bar, {1, 2}, sweep, 11);
    ASSERT_EQ(states.size(), 11u);
    expect_states_of(four_bar, {1, 2}, states);
    EXPECT_NEAR(states.front().configuration.input_angle, 0.8, 1e-15);
    EXPECT_NEAR(states[5].configuration.input_angle, 0.8 + sweep / 2, 1e-15);
    EXPECT_NEAR(states.back().configuration.input_angle, 0.8 + sweep, 1e-15);
    for (const MotionState& state : states) EXPECT_EQ(assembly_of(state.four_bar), Assembly::negative);
  }
}

TEST(MotionSweep, StopsAtADeadPoint) {
  const FourBar four_bar = four_bar_at(rocker_crank, radians(-40), Assembly::positive);
  for (const auto& [sweep, end_deg] : {std::pair{1.0, -24.1468}, {-1.0, -71.7900}}) {
    const auto states = motion_sweep(four_bar, {1, 2}, sweep, 11);
    ASSERT_EQ(states.size(), 11u);
    EXPECT_NEAR(degrees(states.back().configuration.input_angle), end_deg, 1e-3);
    EXPECT_FALSE(states.back().rates.has_value());
  }
}

TEST(MotionSweep, OfACrankMayGoRoundMoreThanOnce) {
  const auto states = motion_sweep(four_bar_at(crank_rocker, 3, Assembly::positive), {}, 3 * two_pi, 31);
  ASSERT_EQ(states.size(), 31u);
  EXPECT_LT(distance(states[0], states[30]), 1e-13);
}

TEST(Motion, OfHostileInputIsEmpty) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const FourBar four_bar = four_bar_at(crank_rocker, 3, Assembly::positive);
  EXPECT_TRUE(motion_cycle(four_bar, {}, 1).empty());
  EXPECT_TRUE(motion_cycle(four_bar, {nan, 0}, 10).empty());
  EXPECT_TRUE(motion_cycle({}, {}, 10).empty());
  EXPECT_TRUE(motion_cycle({{}, {nan, 1}, {1, 0}, {1, 1}}, {}, 10).empty());
  EXPECT_TRUE(motion_cycle({{}, {infinite, 1}, {1, 0}, {1, 1}}, {}, 10).empty());
  EXPECT_TRUE(motion_sweep(four_bar, {}, nan, 10).empty());
  EXPECT_TRUE(motion_sweep(four_bar, {}, infinite, 10).empty());
  EXPECT_TRUE(motion_sweep(four_bar, {}, 1, -5).empty());
}

}  // namespace
}  // namespace linkwright::coupler_curve_test
