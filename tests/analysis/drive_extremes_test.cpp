#include "linkwright/analysis/drive_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/analysis/transmission_angle.hpp"
#include "linkwright/analysis/velocity.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::drive_extremes_test {
namespace {

std::vector<LinkLengths> drawn_lengths(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> length(1, 10);
  std::vector<LinkLengths> drawn;
  while (std::ssize(drawn) < count) {
    const LinkLengths lengths{length(random), length(random), length(random), length(random)};
    if (!input_ranges(lengths).empty()) drawn.push_back(lengths);
  }
  return drawn;
}

/// The most among many even steps, and where.
TransmissionPeak dense_peak(const LinkLengths& lengths, const AngleRange& range) {
  constexpr int steps = 20'000;
  TransmissionPeak peak{-1, 0};
  for (int k = 0; k <= steps; ++k) {
    const double input = range.from + (range.to - range.from) * k / steps;
    const auto there = assemble(lengths, input, Assembly::negative);
    if (!there) continue;
    if (const double angle = transmission_angle(lengths, *there); angle > peak.angle) peak = {angle, input};
  }
  return peak;
}

TEST(DriveExtremes, TheLargestTransmissionAngleIsThatOfAThousandthOfADegree) {
  for (const LinkLengths& lengths : drawn_lengths(60))
    for (const AngleRange& range : input_ranges(lengths)) {
      const TransmissionPeak peak = largest_transmission_angle(lengths, range), dense = dense_peak(lengths, range);
      EXPECT_GE(peak.angle, dense.angle - 1e-12);
      EXPECT_NEAR(peak.angle, dense.angle, 2e-3);
      EXPECT_GE(peak.input_angle, range.from);
      EXPECT_LE(peak.input_angle, range.to);
      const auto there = assemble(lengths, peak.input_angle, Assembly::positive);
      ASSERT_TRUE(there);
      EXPECT_NEAR(transmission_angle(lengths, *there), peak.angle, 1e-12);
    }
}

// In a table a degree apart it was 89.41° at 52.39°.
TEST(DriveExtremes, ARightAngleIsARightAngle) {
  const LinkLengths lengths{8, 6, 4, 5};
  const TransmissionPeak peak = largest_transmission_angle(lengths, input_ranges(lengths).front());
  EXPECT_NEAR(degrees(peak.angle), 90, 1e-6);
  EXPECT_NEAR(std::abs(degrees(wrap_signed(peak.input_angle))), 52.08, 0.005);
}

TEST(DriveExtremes, OfNoLinksIsNothing) {
  EXPECT_EQ(largest_transmission_angle({0, 1, 1, 1}, {0, 1}).angle, 0);
  EXPECT_FALSE(output_rates_full_turn({0, 1, 1, 1}, Assembly::positive));
  EXPECT_FALSE(output_rates_full_turn({8, 6, 4, 5}, Assembly::positive));  // no crank
}

RatioRange dense_rates(const LinkLengths& lengths, Assembly assembly, double from, double to) {
  constexpr int steps = 40'000;
  RatioRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int k = 0; k <= steps; ++k) {
    const auto there = assemble(lengths, from + (to - from) * k / steps, assembly);
    const double rate = angle_rates(lengths, *there)->output;
    range = {std::min(range.least, rate), std::max(range.most, rate)};
  }
  return range;
}

void expect_extremes(const LinkLengths& lengths) {
  for (const Assembly assembly : {Assembly::positive, Assembly::negative}) {
    const auto found = output_rates_full_turn(lengths, assembly);
    ASSERT_TRUE(found);
    RatioRange dense = dense_rates(lengths, assembly, -pi, pi);
    for (const double line : {0.0, pi})  // where a linkage near its change point is quick
      for (const double width : {1e-1, 1e-3, 1e-5}) {
        const RatioRange near = dense_rates(lengths, assembly, line - width, line + width);
        dense = {std::min(dense.least, near.least), std::max(dense.most, near.most)};
      }
    const double size = dense.most - dense.least;
    EXPECT_LE(found->least, dense.least + 1e-9 * size);
    EXPECT_GE(found->most, dense.most - 1e-9 * size);
    EXPECT_NEAR(found->least, dense.least, 1e-5 * size);
    EXPECT_NEAR(found->most, dense.most, 1e-5 * size);
  }
}

TEST(DriveExtremes, VelocityRatiosOfACrankAreThoseOfManySteps) {
  int cranks = 0;
  for (const LinkLengths& lengths : drawn_lengths(40)) {
    if (!input_is_crank(linkage_type(lengths))) continue;
    ++cranks;
    expect_extremes(lengths);
  }
  EXPECT_GT(cranks, 3);
}

TEST(DriveExtremes, NearAChangePointTheyLieWithinADegree) {
  for (const double off : {1e-2, 1e-4, 1e-6}) expect_extremes({10, 2, 7, 5 + off});
}

}  // namespace
}  // namespace linkwright::drive_extremes_test
