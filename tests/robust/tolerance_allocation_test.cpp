#include "linkwright/robust/tolerance_allocation.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "robust/tolerance_error.hpp"
#include "support/draws.hpp"
#include "support/random_four_bar.hpp"
#include "support/robust_cases.hpp"

namespace linkwright::tolerance_allocation_test {
namespace {

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
}  // namespace linkwright::tolerance_allocation_test
