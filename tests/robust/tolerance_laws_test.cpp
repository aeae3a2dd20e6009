// What holds of every kind of linkage.

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "support/random_six_bar.hpp"
#include "support/robust_cases.hpp"

namespace linkwright::tolerance_laws_test {
namespace {

std::vector<TracingFourBar> guided() {
  const auto file = testing::robust_file("guidance");
  const auto& cell = file["results"][0];
  return testing::robust_positions(cell["par"], cell["phis"], cell["sign"]);
}

SphericalOutput sphere(SphericalOutput::Kind kind) {
  const LinkAngles angles{1.3, 0.5, 1.1, 0.9};
  const auto on_arc = [](double angle) { return Vector3{std::sin(angle), 0, std::cos(angle)}; };
  const SphericalFourBar frame{on_arc(0), on_arc(angles.input), on_arc(angles.ground + angles.output),
                               on_arc(angles.ground)};
  SphericalOutput output{kind, {}};
  for (const double input : {0.3, 1.2, 2.5})
    output.positions.push_back(placed(frame, *assemble(angles, input, Assembly::positive)));
  return output;
}

SixBarOutput six_bar() {
  std::mt19937_64 random(1561);
  for (;;) {
    const auto [task, member] = testing::random_six_bar(random, six_bar_rows()[0]);
    SixBarOutput output{member.six_bar, {}, task.poses[0].pose, 1};
    for (const SixBarTurns& turns : member.turns)
      if (const auto exact = closed(output.six_bar, turns);
          exact && six_bar_transmission(output.six_bar, *exact).sine > 0.5)
        output.positions.push_back(*exact);
    if (output.positions.size() == member.turns.size()) return output;
  }
}

std::vector<LinkageOutput> all_kinds() {
  std::vector<FourBar> bars;
  for (const TracingFourBar& linkage : guided()) bars.push_back(linkage.bars);
  return {pose_output(guided(), 1.5),
          angle_output(bars),
          line_output(guided(), {{0, 0}, {1, 0}}, false),
          sphere(SphericalOutput::Kind::orientation),
          sphere(SphericalOutput::Kind::angle),
          six_bar()};
}

Tolerances times(double factor) {
  Tolerances t{.length = LengthTolerances::all(0.004 * factor)};
  t.clearance = 0.001 * factor;
  t.driver = 0.002 * factor;
  t.link_angle = 0.003 * factor;
  t.samples = 2000;
  return t;
}

TEST(ToleranceLaws, TwiceTheTolerancesAreTwiceTheErrorToFirstOrder) {
  for (const LinkageOutput& output : all_kinds()) {
    const auto one = tolerance_report(output, times(1)), two = tolerance_report(output, times(2));
    ASSERT_TRUE(one && two);
    EXPECT_GT(one->error, 0);
    EXPECT_DOUBLE_EQ(two->error, 2 * one->error);
    EXPECT_DOUBLE_EQ(two->worst_case, 2 * one->worst_case);
    EXPECT_EQ(one->error_realigned.has_value(), is_line(output));
    if (one->error_realigned) {
      EXPECT_DOUBLE_EQ(*two->error_realigned, 2 * *one->error_realigned);
    }
    ASSERT_EQ(one->shares.size(), two->shares.size());
    for (std::size_t i = 0; i < one->shares.size(); ++i) EXPECT_NEAR(one->shares[i].share, two->shares[i].share, 1e-14);
    // Sampled, the same numbers twice as large: the second order alone is between them.
    EXPECT_NEAR(two->sampled.error / one->sampled.error, 2, 0.05);
  }
}

TEST(ToleranceLaws, SharesSumToOneInEachPosition) {
  for (const LinkageOutput& output : all_kinds()) {
    const auto report = tolerance_report(output, times(1));
    ASSERT_TRUE(report);
    double whole = 0;
    std::vector<double> sums(positions_of(output));
    for (const ParameterShare& share : report->shares) {
      whole += share.share;
      ASSERT_EQ(share.per_position.size(), sums.size());
      for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += share.per_position[j];
    }
    EXPECT_NEAR(whole, 1, 1e-13);
    for (const double sum : sums) EXPECT_NEAR(sum, 1, 1e-13);
  }
}

// By common random numbers without exception, not on average only.
TEST(ToleranceLaws, YieldFallsAsTolerancesGrow) {
  for (const LinkageOutput& output : all_kinds()) {
    const double limit = sample_errors(output, times(0)).mean + tolerance_report(output, times(1))->error;
    double last = 1;
    for (const double factor : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0}) {
      Tolerances t = times(factor);
      t.limit = {is_line(output) ? ToleranceLimit::Kind::deviation : ToleranceLimit::Kind::position, limit};
      const double yield = sample_errors(output, t).yield->share;
      EXPECT_LE(yield, last) << factor;
      if (factor == 0) {
        EXPECT_EQ(yield, 1);
      }
      last = yield;
    }
    EXPECT_LT(last, 0.9);
  }
}

// The worst case bounds the samples, but for the second order, when parameters keep within their tolerances.
TEST(ToleranceLaws, NoSampleIsBeyondTheWorstCase) {
  for (const LinkageOutput& output : all_kinds()) {
    Tolerances t = times(0.05);
    t.distribution = ToleranceDistribution::uniform;
    const double worst = tolerance_report(output, t)->worst_case;
    const ErrorSamples is = error_samples(output, t, 2000), was = error_samples(output, times(0), 1);
    for (std::size_t j = 0; j < is.errors.size(); ++j)
      for (const double error : is.errors[j]) EXPECT_LE(std::abs(error - was.errors[j][0]), 1.01 * worst);
  }
}

}  // namespace
}  // namespace linkwright::tolerance_laws_test
