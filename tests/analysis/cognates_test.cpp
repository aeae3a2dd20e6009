#include "linkwright/analysis/cognates.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/analysis/coupler_curve.hpp"
#include "support/draws.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::cognates_test {
namespace {

using testing::draws;
using testing::RandomFourBars;

TracingFourBar random_linkage(RandomFourBars& random, bool on_coupler_line = false) {
  TracingFourBar linkage{random.four_bar(), {}};
  const Point share{random.uniform(-2, 2), on_coupler_line ? 0 : random.uniform(-2, 2)};
  linkage.point = linkage.bars.input_circle + share * (linkage.bars.output_circle - linkage.bars.input_circle);
  return linkage;
}

double difference(const TracingFourBar& a, const TracingFourBar& b) {
  return std::max({std::abs(a.bars.input_center - b.bars.input_center),
                   std::abs(a.bars.input_circle - b.bars.input_circle),
                   std::abs(a.bars.output_center - b.bars.output_center),
                   std::abs(a.bars.output_circle - b.bars.output_circle), std::abs(a.point - b.point)});
}

// How far the output's length is from fitting where the point is somewhere: of the two ways in which the driving dyad
// reaches there the better one.
double misfit(const TracingFourBar& linkage, Point point) {
  const FourBar& bars = linkage.bars;
  const Point way = point - bars.input_center;
  const double crank = bars.lengths().input, arm = std::abs(linkage.point - bars.input_circle), far = std::abs(way);
  const double cosine = (crank * crank + far * far - arm * arm) / (2 * crank * far);
  double best = std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const Point pin =
        bars.input_center + std::polar(crank, std::arg(way) + side * std::acos(std::clamp(cosine, -1.0, 1.0)));
    const Point turn = (point - pin) / (linkage.point - bars.input_circle);
    const Point output = pin + turn * (bars.output_circle - bars.input_circle);
    best = std::min(best, std::abs(std::abs(output - bars.output_center) - bars.lengths().output) +
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
    other.bars.output_center += 0.01 * other.longest();
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
    const double first = std::abs(linkage.point - linkage.bars.input_circle),
                 second = std::abs(linkage.point - linkage.bars.output_circle);
    const auto expect = [&](const TracingFourBar& other, double arm, double share, const LinkLengths& of) {
      const LinkLengths found = other.bars.lengths();
      EXPECT_NEAR(found.ground, share * of.ground, 1e-12 * other.longest());
      EXPECT_NEAR(found.input, arm, 1e-12 * other.longest());
      EXPECT_NEAR(found.coupler, share * of.input, 1e-12 * other.longest());
      EXPECT_NEAR(found.output, share * of.output, 1e-12 * other.longest());
      EXPECT_NEAR(std::abs(other.point - other.bars.input_circle), of.input, 1e-12 * other.longest());
    };
    expect((*others)[0], first, first / l.coupler, l);
    expect((*others)[1], second, second / l.coupler, l.swapped());
    EXPECT_LT(std::abs((*others)[0].bars.output_center - (*others)[1].bars.output_center),
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
    EXPECT_NEAR(std::abs(other.point - other.bars.input_circle), 5, 1e-15);
    EXPECT_NEAR(std::abs(other.point - other.bars.output_circle), 2.5, 1e-15);
    EXPECT_LT(
        difference(cognates(other)->front(), chebyshev) * difference(cognates(other)->front(), chebyshev.swapped()),
        1e-14);
  }
}

TEST(Cognates, AreNoneWhereThePointIsAPivotOrTheCouplerHasNoLength) {
  const FourBar bars{{0, 0}, {0, 1}, {3, 0}, {3, 2}};
  EXPECT_FALSE(cognates({bars, bars.input_circle}));
  EXPECT_FALSE(cognates({bars, bars.output_circle}));
  EXPECT_FALSE(cognates({bars, bars.output_circle + 1e-8}));
  EXPECT_TRUE(cognates({bars, bars.output_circle + 1e-3}));
  EXPECT_FALSE(cognates({{{0, 0}, {1, 1}, {3, 0}, {1, 1}}, {2, 2}}));
}

}  // namespace
}  // namespace linkwright::cognates_test
