#include "mechanism/transmission_angle.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::transmission_angle_test {
namespace {

using testing::RandomFourBars;

constexpr LinkLengths crank_rocker{4, 1, 3, 2};  // flat at 180°
constexpr int samples = 4000;

// What driving shows; 0 where the linkage cannot be.
double sampled_least(const LinkLengths& lengths, double from, double to) {
  double least = pi;
  for (int i = 0; i <= samples; ++i) {
    const auto c = assemble(lengths, from + (to - from) * i / samples, Assembly::positive);
    least = std::min(least, c ? transmission_angle(lengths, *c) : 0);
  }
  return least;
}

// github coleas33/linkage_sim tests/test_transmission_angle.py: ground 4, crank 1, coupler 3, follower 2.
TEST(TransmissionAngle, AgreesWithAPublishedExample) {
  const auto at = [](double deg) {
    return degrees(transmission_angle(crank_rocker, *assemble(crank_rocker, radians(deg), Assembly::positive)));
  };
  EXPECT_NEAR(at(0), 70.52877936550931, 1e-12);
  EXPECT_NEAR(at(60), 90, 1e-12);
}

TEST(TransmissionAngle, IsThatBetweenCouplerAndOutputWhicheverIsAcute) {
  RandomFourBars random(21);
  for (int i = 0; i < 3000; ++i) {
    const FourBar f = random.four_bar();
    const Point to_input = f.input_moving - f.output_moving, to_center = f.output_fixed - f.output_moving;
    const double between = std::atan2(std::abs(cross(to_input, to_center)), std::abs(dot(to_input, to_center)));
    EXPECT_NEAR(transmission_angle(f.lengths(), configuration_of(f)), between, 1e-13);
  }
}

TEST(TransmissionAngle, IsTheSameInBothAssembliesAndVanishesAtDeadPoints) {
  const LinkLengths lengths{3, 2, 2.2, 2.1};
  EXPECT_NEAR(transmission_angle(lengths, *assemble(lengths, 0.7, Assembly::positive)),
              transmission_angle(lengths, *assemble(lengths, 0.7, Assembly::negative)), 1e-15);
  for (const DeadPoint& dead : dead_points(lengths))
    EXPECT_NEAR(transmission_angle(lengths, dead.configuration), 0, 1e-15);
}

TEST(LeastTransmissionAngle, AgreesWithDenseSampling) {
  RandomFourBars random(22);
  int positive = 0;
  for (int i = 0; i < 1500; ++i) {
    const LinkLengths lengths = random.lengths();
    const double from = i % 2 ? random.input_angle(lengths) : random.uniform(-10, 10);
    const double to = from + random.uniform(-two_pi, two_pi) * (i % 3 ? 0.2 : 1);
    const double exact = least_transmission_angle(lengths, from, to), sampled = sampled_least(lengths, from, to);
    positive += exact > 0;
    // Between samples γ falls by less than its slope, which is large only near 0, times the step.
    EXPECT_LE(exact, sampled + 1e-12);
    EXPECT_GE(exact, sampled - 0.08) << "linkage " << i;
  }
  EXPECT_GT(positive, 500);
}

TEST(LeastTransmissionAngle, IsThatAtTheExtremesOfTheDiagonalWithinTheSweep) {
  const LinkLengths l{4, 1, 3, 2.5};
  const auto at = [&](double deg) { return transmission_angle(l, *assemble(l, radians(deg), Assembly::positive)); };
  const auto least = [&](double from, double to) { return least_transmission_angle(l, radians(from), radians(to)); };
  EXPECT_NEAR(least(-20, 50), std::min(at(0), at(50)), 1e-14);
  EXPECT_NEAR(least(150, 200), at(180), 1e-14);
  EXPECT_NEAR(least(200, 150), at(180), 1e-14) << "either way";
  EXPECT_NEAR(least(150 - 720, 200 - 720), at(180), 1e-13) << "whole turns do not matter";
  EXPECT_NEAR(least(30, 40), std::min(at(30), at(40)), 1e-14);
  EXPECT_NEAR(least(33, 33), at(33), 1e-14);
}

TEST(LeastTransmissionAngle, VanishesOnTheWayOverADeadPoint) {
  const LinkLengths rocker_crank{4, 2.5, 3, 1};
  EXPECT_GT(least_transmission_angle(rocker_crank, radians(30), radians(60)), 0.1);
  EXPECT_EQ(least_transmission_angle(rocker_crank, radians(30), radians(80)), 0);
  EXPECT_EQ(least_transmission_angle(rocker_crank, radians(-30), radians(30)), 0) << "through the gap at 0";
  EXPECT_EQ(least_transmission_angle(rocker_crank, radians(100), radians(120)), 0) << "nowhere there";
}

TEST(LeastTransmissionAngle, OverAFullTurnIsThatOfACrankAndNothingElse) {
  RandomFourBars random(23);
  for (int i = 0; i < 1000; ++i) {
    const LinkLengths lengths = random.lengths();
    const double full = least_transmission_angle_full_turn(lengths);
    if (!input_is_crank(linkage_type(lengths))) {
      EXPECT_EQ(full, 0);
      continue;
    }
    const double from = random.uniform(-pi, pi);
    EXPECT_NEAR(full, least_transmission_angle(lengths, from, from + two_pi), 1e-12);
    EXPECT_NEAR(full,
                std::min(transmission_angle(lengths, *assemble(lengths, 0, Assembly::positive)),
                         transmission_angle(lengths, *assemble(lengths, pi, Assembly::positive))),
                1e-12);
  }
}

TEST(LeastTransmissionAngle, DoesNotDependOnSize) {
  const LinkLengths l{4, 1, 3, 2.5};
  for (const double s : {1e-6, 1e6}) {
    const LinkLengths large{s * l.ground, s * l.input, s * l.coupler, s * l.output};
    EXPECT_NEAR(least_transmission_angle(large, 0.3, 2), least_transmission_angle(l, 0.3, 2), 1e-14);
  }
}

TEST(TransmissionAngle, OfHostileInputIsZero) {
  const double nan = std::nan("");
  EXPECT_EQ(transmission_angle({4, 1, 0, 2}, {1, 2, 3}), 0);
  EXPECT_EQ(transmission_angle({4, 1, nan, 2}, {1, 2, 3}), 0);
  EXPECT_EQ(transmission_angle({4, 1, 3, 2}, {1, nan, 3}), 0);
  EXPECT_EQ(least_transmission_angle({4, 1, nan, 2}, 0, 1), 0);
  EXPECT_EQ(least_transmission_angle({4, 1, 3, 2.5}, nan, 1), 0);
  EXPECT_EQ(least_transmission_angle({40, 1, 3, 2.5}, 0, 1), 0);
  EXPECT_EQ(least_transmission_angle_full_turn({0, 0, 0, 0}), 0);
}

}  // namespace
}  // namespace linkwright::transmission_angle_test
