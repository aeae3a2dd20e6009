#include "linkwright/analysis/velocity.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::velocity_test {
namespace {

using testing::RandomFourBars;

TEST(AngleRates, AgreeWithCentralDifferences) {
  RandomFourBars random(31);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    const LinkLengths lengths = random.lengths();
    const double angle = random.input_angle(lengths), step = 1e-4;
    const Assembly assembly = random.assembly();
    const auto before = assemble(lengths, angle - step, assembly), at = assemble(lengths, angle, assembly),
               after = assemble(lengths, angle + step, assembly);
    if (!before || !after || std::abs(std::sin(at->coupler_angle - at->output_angle)) < 0.2) continue;
    const auto rates = angle_rates(lengths, *at);
    ASSERT_TRUE(rates.has_value());
    const auto back = angle_rates(lengths, *before), ahead = angle_rates(lengths, *after);
    const auto slope = [&](double from, double to) { return (to - from) / (2 * step); };
    // Truncation is step²/6 times the third derivative, which grows with the fifth power of 1/sin μ and with rates.
    const double rate = 1 + std::max(std::abs(rates->coupler), std::abs(rates->output));
    const double tolerance = 1e-3 * rate * rate * rate;
    EXPECT_NEAR(rates->coupler, slope(0, wrap_signed(after->coupler_angle - before->coupler_angle)), tolerance);
    EXPECT_NEAR(rates->output, slope(0, wrap_signed(after->output_angle - before->output_angle)), tolerance);
    EXPECT_NEAR(rates->coupler_acceleration, slope(back->coupler, ahead->coupler), tolerance * rate);
    EXPECT_NEAR(rates->output_acceleration, slope(back->output, ahead->output), tolerance * rate);
    ++compared;
  }
  EXPECT_GT(compared, 3000);
}

// The loop equation differentiated: what the drawing of velocities and accelerations must close to.
TEST(AngleRates, CloseTheVelocityAndTheAccelerationPolygon) {
  RandomFourBars random(32);
  for (int i = 0; i < 5000; ++i) {
    const LinkLengths l = random.lengths();
    const auto c = assemble(l, random.input_angle(l), random.assembly());
    const auto r = angle_rates(l, *c);
    ASSERT_TRUE(r.has_value());
    const Point turn{0, 1};
    const Point a = l.input * direction(c->input_angle), h = l.coupler * direction(c->coupler_angle),
                b = l.output * direction(c->output_angle);
    const Point velocity = turn * (a + r->coupler * h - r->output * b);
    EXPECT_LT(std::abs(velocity), 1e-13 * (1 + std::abs(r->coupler) + std::abs(r->output)));
    const auto acceleration = [&](double rate, double second) { return turn * second - rate * rate; };
    const Point gap = acceleration(1, 0) * a + acceleration(r->coupler, r->coupler_acceleration) * h -
                      acceleration(r->output, r->output_acceleration) * b;
    EXPECT_LT(std::abs(gap), 1e-13 * (1 + std::abs(r->coupler_acceleration) + std::abs(r->output_acceleration)));
  }
}

TEST(AngleRates, OfAParallelogramAreThoseOfATranslatingCoupler) {
  const LinkLengths parallelogram{3, 2, 3, 2};
  const auto rates = angle_rates(parallelogram, {1, 0, 1});
  ASSERT_TRUE(rates.has_value());
  EXPECT_NEAR(rates->coupler, 0, 1e-15);
  EXPECT_NEAR(rates->output, 1, 1e-15);
  EXPECT_NEAR(rates->coupler_acceleration, 0, 1e-15);
  EXPECT_NEAR(rates->output_acceleration, 0, 1e-15);
}

TEST(AngleRates, DoNotExistAtDeadPoints) {
  for (const LinkLengths lengths : {LinkLengths{3, 2, 2.2, 2.1}, {4, 2.5, 3, 1}, {4, 3, 1.5, 3.2}})
    for (const DeadPoint& dead : dead_points(lengths)) EXPECT_FALSE(angle_rates(lengths, dead.configuration));
}

TEST(AngleRates, DoNotDependOnSize) {
  const LinkLengths l{4, 1, 3, 2.5};
  const Configuration c = *assemble(l, 1, Assembly::positive);
  for (const double s : {1e-6, 1e6}) {
    const auto rates = angle_rates({s * l.ground, s * l.input, s * l.coupler, s * l.output}, c);
    EXPECT_NEAR(rates->output_acceleration, angle_rates(l, c)->output_acceleration, 1e-14);
  }
}

TEST(AngleRates, OfHostileInputDoNotExist) {
  const double nan = std::nan("");
  EXPECT_FALSE(angle_rates({4, 1, 0, 2.5}, {1, 2, 3}));
  EXPECT_FALSE(angle_rates({4, 1, 3, nan}, {1, 2, 3}));
  EXPECT_FALSE(angle_rates({4, 1, 3, 2.5}, {nan, 2, 3}));
  EXPECT_FALSE(angle_rates({4, 1, 3, 2.5}, {1, nan, 3}));
}

}  // namespace
}  // namespace linkwright::velocity_test
