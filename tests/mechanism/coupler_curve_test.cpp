#include "linkwright/mechanism/coupler_curve.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "mechanism/transmission_angle.hpp"
#include "support/draws.hpp"
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
    return (p - f.input_moving) / (f.output_moving - f.input_moving);
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
  return std::max({std::abs(a.four_bar.input_moving - b.four_bar.input_moving),
                   std::abs(a.four_bar.output_moving - b.four_bar.output_moving),
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
        {move(f.input_fixed), move(f.input_moving), move(f.output_fixed), move(f.output_moving)}, move(traced), 20);
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

using testing::draws;
using testing::RandomFourBars;

TracingFourBar random_linkage(RandomFourBars& random, bool on_coupler_line = false) {
  TracingFourBar linkage{random.four_bar(), {}};
  const Point share{random.uniform(-2, 2), on_coupler_line ? 0 : random.uniform(-2, 2)};
  linkage.point = linkage.bars.input_moving + share * (linkage.bars.output_moving - linkage.bars.input_moving);
  return linkage;
}

double difference(const TracingFourBar& a, const TracingFourBar& b) {
  return std::max({std::abs(a.bars.input_fixed - b.bars.input_fixed),
                   std::abs(a.bars.input_moving - b.bars.input_moving),
                   std::abs(a.bars.output_fixed - b.bars.output_fixed),
                   std::abs(a.bars.output_moving - b.bars.output_moving), std::abs(a.point - b.point)});
}

// How far the output's length is from fitting where the point is somewhere: of the two ways in which the driving dyad
// reaches there the better one.
double misfit(const TracingFourBar& linkage, Point point) {
  const FourBar& bars = linkage.bars;
  const Point way = point - bars.input_fixed;
  const double crank = bars.lengths().input, arm = std::abs(linkage.point - bars.input_moving), far = std::abs(way);
  const double cosine = (crank * crank + far * far - arm * arm) / (2 * crank * far);
  double best = std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const Point pin =
        bars.input_fixed + std::polar(crank, std::arg(way) + side * std::acos(std::clamp(cosine, -1.0, 1.0)));
    const Point turn = (point - pin) / (linkage.point - bars.input_moving);
    const Point output = pin + turn * (bars.output_moving - bars.input_moving);
    best = std::min(best, std::abs(std::abs(output - bars.output_fixed) - bars.lengths().output) +
                              std::max(std::abs(cosine) - 1, 0.0));
  }
  return best;
}

void expect_same_curve(const TracingFourBar& a, const TracingFourBar& b) {
  for (const MotionState& state : motion_cycle(a.bars, a.point, 25))
    EXPECT_LT(misfit(b, state.coupler_point), 1e-6 * b.longest());
}

TEST(Cognates, TraceTheSameCurve) {
  RandomFourBars random(14);
  for (int i = 0; i < draws(500); ++i) {
    const TracingFourBar linkage = random_linkage(random, i % 5 == 0);
    const auto others = cognates(linkage);
    ASSERT_TRUE(others);
    for (const TracingFourBar& other : *others) {
      SCOPED_TRACE(i);
      EXPECT_EQ(other.point, linkage.point);
      expect_same_curve(linkage, other);
      expect_same_curve(other, linkage);
    }
  }
}

TEST(Cognates, TraceOtherCurvesOnceALinkIsChanged) {
  RandomFourBars random(15);
  int off = 0;
  for (int i = 0; i < draws(100); ++i) {
    const TracingFourBar linkage = random_linkage(random);
    TracingFourBar other = cognates(linkage)->front();
    other.bars.output_fixed += 0.01 * other.longest();
    for (const MotionState& state : motion_cycle(linkage.bars, linkage.point, 25))
      if (misfit(other, state.coupler_point) > 1e-4 * other.longest()) {
        ++off;
        break;
      }
  }
  EXPECT_GE(off, draws(90));
}

TEST(Cognates, AreThreeInAll) {
  RandomFourBars random(16);
  for (int i = 0; i < draws(500); ++i) {
    const TracingFourBar linkage = random_linkage(random);
    const auto others = cognates(linkage);
    const auto of_first = cognates((*others)[0]), of_second = cognates((*others)[1]);
    if (!of_first || !of_second) continue;
    const double rounding = 1e-10 * (linkage.longest() + (*others)[0].longest() + (*others)[1].longest());
    EXPECT_LT(difference((*of_first)[0], linkage), rounding);
    EXPECT_LT(difference((*of_second)[0], linkage.swapped()), rounding);
    EXPECT_LT(difference((*of_first)[1], (*others)[1].swapped()), rounding);
    EXPECT_LT(difference((*of_second)[1], (*others)[0].swapped()), rounding);
  }
}

// Triangles of the three couplers and of the three centres are similar.
TEST(Cognates, HaveTheLengthsOfSimilarTriangles) {
  RandomFourBars random(17);
  for (int i = 0; i < draws(500); ++i) {
    const TracingFourBar linkage = random_linkage(random);
    const LinkLengths l = linkage.bars.lengths();
    const auto others = cognates(linkage);
    const double first = std::abs(linkage.point - linkage.bars.input_moving),
                 second = std::abs(linkage.point - linkage.bars.output_moving);
    const auto expect = [&](const TracingFourBar& other, double arm, double share, const LinkLengths& of) {
      const LinkLengths found = other.bars.lengths();
      EXPECT_NEAR(found.ground, share * of.ground, 1e-12 * other.longest());
      EXPECT_NEAR(found.input, arm, 1e-12 * other.longest());
      EXPECT_NEAR(found.coupler, share * of.input, 1e-12 * other.longest());
      EXPECT_NEAR(found.output, share * of.output, 1e-12 * other.longest());
      EXPECT_NEAR(std::abs(other.point - other.bars.input_moving), of.input, 1e-12 * other.longest());
    };
    expect((*others)[0], first, first / l.coupler, l);
    expect((*others)[1], second, second / l.coupler, l.swapped());
    EXPECT_LT(std::abs((*others)[0].bars.output_fixed - (*others)[1].bars.output_fixed),
              1e-12 * (*others)[0].longest());
  }
}

TEST(Cognates, OfChebyshevsLinkageAreHoeckens) {
  // 4 : 5 : 2 : 5, crossed, in the middle of its line.
  const TracingFourBar chebyshev{{{0, 0}, {3, 4}, {4, 0}, {1, 4}}, {2, 4}};
  const auto others = cognates(chebyshev);
  ASSERT_TRUE(others);
  for (const TracingFourBar& other : *others) {
    const LinkLengths lengths = other.bars.lengths();
    EXPECT_NEAR(lengths.input, 1, 1e-15);
    EXPECT_NEAR(lengths.ground, 2, 1e-15);
    EXPECT_NEAR(lengths.coupler, 2.5, 1e-15);
    EXPECT_NEAR(lengths.output, 2.5, 1e-15);
    EXPECT_NEAR(std::abs(other.point - other.bars.input_moving), 5, 1e-15);
    EXPECT_NEAR(std::abs(other.point - other.bars.output_moving), 2.5, 1e-15);
    EXPECT_LT(
        difference(cognates(other)->front(), chebyshev) * difference(cognates(other)->front(), chebyshev.swapped()),
        1e-14);
  }
}

TEST(Cognates, AreNoneWhereThePointIsAPivotOrTheCouplerHasNoLength) {
  const FourBar bars{{0, 0}, {0, 1}, {3, 0}, {3, 2}};
  EXPECT_FALSE(cognates({bars, bars.input_moving}));
  EXPECT_FALSE(cognates({bars, bars.output_moving}));
  EXPECT_FALSE(cognates({bars, bars.output_moving + 1e-8}));
  EXPECT_TRUE(cognates({bars, bars.output_moving + 1e-3}));
  EXPECT_FALSE(cognates({{{0, 0}, {1, 1}, {3, 0}, {1, 1}}, {2, 2}}));
}

}  // namespace
}  // namespace linkwright::coupler_curve_test
