#include "linkwright/robust/tolerance_report.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "robust/tolerance_error.hpp"
#include "support/draws.hpp"
#include "support/random_four_bar.hpp"
#include "support/robust_cases.hpp"

namespace linkwright::tolerance_report_test {
namespace {

PlanarOutput pose_of_cell(int cell) {
  const auto file = testing::robust_file("guidance");
  const auto& result = file["results"][static_cast<std::size_t>(cell)];
  return pose_output(testing::robust_positions(result["par"], result["phis"], result["sign"]), file["Lth"]);
}

// The point of a cell, as if it were to stay on a line.
PlanarOutput line_of_cell(int cell, bool realigned = false) {
  return line_output(pose_of_cell(cell).positions, {{0, 0}, {1, 0}}, realigned);
}

TEST(ToleranceReport, IsWhatItsPartsSay) {
  Tolerances t{.length = {0.01, 0.01, 0.01, 0, 0.02}, .clearance = 0.001, .driver = 0.002};
  t.cost_exponent = 1.5;
  const PlanarOutput output = pose_of_cell(0);
  const auto report = tolerance_report(output, t);
  ASSERT_TRUE(report);
  const SensitivityMatrix matrix = sensitivities(output).value();
  EXPECT_EQ(report->error, tolerance_error(matrix, planar_variances(t)));
  EXPECT_EQ(report->worst_case, worst_case(matrix, planar_reach(t)));
  EXPECT_EQ(report->sampled.error, sample_errors(output, t).error);
  EXPECT_FALSE(report->error_realigned || report->sampled_realigned);
  ASSERT_EQ(report->shares.size(), 6u);  // the ground pivots cannot be off
  double sum = 0, last = 1;
  for (const ParameterShare& share : report->shares) {
    EXPECT_LE(share.share, last);
    EXPECT_EQ(share.per_position.size(), output.positions.size());
    EXPECT_EQ(share.tolerance, share.parameter == "driver"                                             ? 0.002
                               : share.parameter == "point_along" || share.parameter == "point_across" ? 0.02
                                                                                                       : 0.01);
    sum += share.share;
    last = share.share;
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  ASSERT_TRUE(report->allocation);
  EXPECT_EQ(report->allocation->size(), 5u);
}

TEST(ToleranceReport, ListsTheSampledErrorBeyondFirstOrder) {
  const Tolerances fine{.length = LengthTolerances::all(0.0005)}, coarse{.length = LengthTolerances::all(0.01)};
  const auto within = tolerance_report(pose_of_cell(1), fine), beyond = tolerance_report(pose_of_cell(1), coarse);
  EXPECT_FALSE(within->beyond_first_order);
  EXPECT_EQ(within->listed_error(), within->error);
  EXPECT_TRUE(beyond->beyond_first_order);
  EXPECT_EQ(beyond->listed_error(), beyond->sampled.error);
}

// Where its one sample is too short to reach, there is no sampled error to be listed.
TEST(ToleranceReport, ListsTheFirstOrderWhereNoSampleAssembles) {
  const TracingFourBar nearly_flat{{{0, 0}, {1, 0}, {3, 0.01}, {4, 0}}, {1, 1}};
  int none = 0;
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    Tolerances t{.length = {.output = 0.1}};
    t.samples = 1;
    t.seed = seed;
    const auto report = tolerance_report(pose_output({nearly_flat}, 1), t);
    ASSERT_TRUE(report);
    if (report->sampled.assembled() > 0) continue;
    ++none;
    EXPECT_FALSE(report->beyond_first_order);
    EXPECT_EQ(report->listed_error(), report->error);
  }
  EXPECT_GT(none, 0);
}

TEST(ToleranceReport, LaysLinesAnew) {
  const Tolerances t{.length = LengthTolerances::all(0.001)};
  for (const bool realigned : {false, true}) {
    const auto report = tolerance_report(line_of_cell(0, realigned), t);
    ASSERT_TRUE(report && report->error_realigned && report->sampled_realigned);
    const SensitivityMatrix fixed = sensitivities(line_of_cell(0)).value(),
                            anew = sensitivities(line_of_cell(0, true)).value();
    EXPECT_EQ(report->error, line_tolerance_error(fixed, planar_variances(t)));
    EXPECT_EQ(*report->error_realigned, line_tolerance_error(anew, planar_variances(t)));
    EXPECT_EQ(report->sampled.error, sample_errors(line_of_cell(0), t).error);
    EXPECT_EQ(report->sampled_realigned->error, sample_errors(line_of_cell(0, true), t).error);
    EXPECT_LT(*report->error_realigned, report->error);
    EXPECT_FALSE(report->allocation);
  }
}

TEST(ToleranceReport, IsNothingAtADeadPoint) {
  const FourBar flat{{0, 0}, {1, 0}, {4, 0}, {2, 0}};
  EXPECT_FALSE(tolerance_report(angle_output(std::vector{flat}), {.length = LengthTolerances::all(0.01)}));
}

TEST(ToleranceAllocation, CostsLeastOfAllThatKeepTheError) {
  testing::RandomFourBars random(1512);
  for (int n = 0; n < testing::draws(200); ++n) {
    const double exponent = random.uniform(0.3, 3), error = random.uniform(0.1, 2);
    const std::array<double, 4> weights = {random.uniform(0.1, 5), random.uniform(0.1, 5), random.uniform(0.1, 5), 0};
    const auto tolerances = least_cost_tolerances(weights, error, exponent);
    const auto cost = [&](std::span<const double> t) {
      return std::pow(t[0], -exponent) + std::pow(t[1], -exponent) + std::pow(t[2], -exponent);
    };
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) square += std::pow(weights[i] * tolerances[i], 2);
    EXPECT_NEAR(std::sqrt(square), error, 1e-12 * error);
    EXPECT_EQ(tolerances[3], std::numeric_limits<double>::infinity());
    // Any other point of the ellipsoid costs more: w T = error · (cos u cos v, sin u cos v, sin v).
    const double least = cost(tolerances);
    double cheapest = std::numeric_limits<double>::infinity();
    for (int i = 1; i < 200; ++i)
      for (int k = 1; k < 200; ++k) {
        const double u = pi / 2 * i / 200, v = pi / 2 * k / 200;
        const std::array<double, 3> other = {error * std::cos(u) * std::cos(v) / weights[0],
                                             error * std::sin(u) * std::cos(v) / weights[1],
                                             error * std::sin(v) / weights[2]};
        cheapest = std::min(cheapest, cost(other));
      }
    EXPECT_GE(cheapest, least * (1 - 1e-12));
    EXPECT_LE(cheapest, least * 1.01);
  }
}

SensitivityMatrix function_matrix() {
  const auto file = testing::robust_file("function");
  std::vector<FourBar> bars;
  for (const auto& linkage : testing::robust_positions(file["par"], file["phis"], file["sign"]))
    bars.push_back(linkage.bars);
  return sensitivities(angle_output(bars)).value();
}

TEST(ToleranceAllocation, KeepsTheErrorForLess) {
  const SensitivityMatrix matrix = function_matrix();
  Tolerances t{.length = LengthTolerances::all(0.005), .clearance = 0.002, .driver = 1e-4};
  t.cost_exponent = 2;
  const double error = tolerance_error(matrix, planar_variances(t));
  const auto dimensions = made_dimensions(PlanarOutput{}, t);
  const auto allocated = allocated_tolerances(matrix, dimensions, t, error);
  ASSERT_TRUE(allocated);
  ASSERT_EQ(allocated->size(), 7u);  // the point does not matter, the driver stays
  Tolerances staying = t;
  staying.length = {};
  PlanarValues variances = planar_variances(staying);
  double cost = 0;
  for (const ParameterTolerance& one : *allocated) {
    for (std::size_t i = 0; i < dimensions.size(); ++i)
      if (dimensions[i].name == one.parameter) variances[i] += std::pow(one.tolerance / 3, 2);
    cost += std::pow(one.tolerance, -2);
  }
  EXPECT_NEAR(tolerance_error(matrix, variances), error, 1e-12 * error);
  EXPECT_LT(cost, 7 * std::pow(0.005, -2));
}

TEST(ToleranceAllocation, IsNothingWithoutRoom) {
  const SensitivityMatrix matrix = function_matrix();
  Tolerances t{.length = LengthTolerances::all(0.005), .clearance = 0.002};
  const double error = tolerance_error(matrix, planar_variances(t));
  const auto allocated = [&](double kept) {
    return allocated_tolerances(matrix, made_dimensions(PlanarOutput{}, t), t, kept);
  };
  EXPECT_FALSE(allocated(error));
  t.cost_exponent = 1;
  EXPECT_TRUE(allocated(error));
  EXPECT_FALSE(allocated(error / 10));
  t.length = {.point = 0.1};
  EXPECT_FALSE(allocated(error));
}

}  // namespace
}  // namespace linkwright::tolerance_report_test
