#include "robust/tolerance_error.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/simd.hpp"
#include "robust/tolerance_error_kernel.hpp"
#include "straight_line/symmetric_lambda.hpp"
#include "support/draws.hpp"
#include "support/random_four_bar.hpp"
#include "support/robust_cases.hpp"

namespace linkwright::tolerance_error_test {
namespace {

std::vector<FourBar> bars_of(const std::vector<TracingFourBar>& positions) {
  std::vector<FourBar> bars;
  for (const auto& linkage : positions) bars.push_back(linkage.bars);
  return bars;
}

SensitivityMatrix function_matrix() {
  const auto file = testing::robust_file("function");
  return sensitivities(angle_output(bars_of(testing::robust_positions(file["par"], file["phis"], file["sign"]))))
      .value();
}

Tolerances tolerances_of(const nlohmann::json& result) {
  Tolerances t{.length = LengthTolerances::all(0.005), .clearance = result.at("clearance")};
  t.distribution = tolerance_distribution_named(result.at("dist").get<std::string>()).value();
  return t;
}

TEST(ToleranceError, IsThatOfThePublishedFunctions) {
  const auto file = testing::robust_file("function");
  const SensitivityMatrix matrix = function_matrix();
  for (const auto& result : file["results"]) {
    const Tolerances t = tolerances_of(result);
    const auto deviations = standard_deviations(matrix, planar_variances(t));
    ASSERT_EQ(deviations.size(), result["linear_sigma"].size());
    for (std::size_t j = 0; j < deviations.size(); ++j) EXPECT_NEAR(deviations[j], result["linear_sigma"][j], 1e-12);
    EXPECT_NEAR(worst_case(matrix, planar_half_tolerances(t)), result["worst_case"][0], 1e-12);
  }
}

TEST(ToleranceError, IsThatOfTheGuidanceCells) {
  const auto file = testing::robust_file("guidance");
  const Tolerances t{.length = LengthTolerances::all(0.01)};
  for (const auto& cell : file["results"]) {
    const auto positions = testing::robust_positions(cell["par"], cell["phis"], cell["sign"]);
    const auto matrix = sensitivities(pose_output(positions, file["Lth"]));
    ASSERT_TRUE(matrix);
    EXPECT_NEAR(tolerance_error(*matrix, planar_variances(t)), cell["linear_sigma"], 1e-9);
  }
}

// The λ of a crank range, over its stroke of 100.
std::vector<TracingFourBar> lambda_stroke(double crank_range) {
  const auto lambda = near_minimax_lambda(crank_range, 100);
  const TracingFourBar middle = lambda_linkage(*lambda, {}, false);
  const Configuration now = configuration_of(middle.bars);
  std::vector<TracingFourBar> stroke;
  for (int k = -20; k <= 20; ++k) {
    const auto there =
        assemble(middle.bars.lengths(), now.input_angle + k * crank_range / 40, assembly_of(middle.bars));
    stroke.push_back(middle.moved_to(placed(middle.bars, there.value())));
  }
  return stroke;
}

TEST(ToleranceError, IsThatOfLambdaLinkages) {
  const Tolerances t{.length = LengthTolerances::all(0.05)};
  const auto file = testing::robust_file("lambda");
  for (const auto& result : file["results"]) {
    const auto stroke = lambda_stroke(radians(result["beta_deg"].get<double>()));
    const auto fixed = sensitivities(line_output(stroke, {}, false));
    const auto realigned = sensitivities(line_output(stroke, {}, true));
    ASSERT_TRUE(fixed && realigned);
    const auto deviations = standard_deviations(*fixed, planar_variances(t));
    EXPECT_NEAR(deviations.front(), result["sigma_end"], 1e-6);
    EXPECT_NEAR(deviations[20], result["sigma_mid"], 1e-6);
    EXPECT_DOUBLE_EQ(line_tolerance_error(*fixed, planar_variances(t)),
                     3 * *std::max_element(deviations.begin(), deviations.end()));
    // What is left once the line has been laid anew is a small part of it.
    EXPECT_LT(line_tolerance_error(*realigned, planar_variances(t)),
              0.2 * line_tolerance_error(*fixed, planar_variances(t)));
  }
}

TEST(ToleranceError, IsTwiceThatOfHalfTheTolerances) {
  testing::RandomFourBars random(1511);
  for (int n = 0; n < testing::draws(300); ++n) {
    const auto matrix = sensitivities(pose_output({{random.four_bar(), {random.uniform(-3, 3), 1}}}, 0.7));
    if (!matrix) continue;
    Tolerances t{.length = {0.1, 0.2, 0.3, 0.4, 0.5}, .clearance = 0.05, .driver = 0.01};
    const double error = tolerance_error(*matrix, planar_variances(t));
    const double worst = worst_case(*matrix, planar_reach(t));
    t = {.length = {0.2, 0.4, 0.6, 0.8, 1}, .clearance = 0.1, .driver = 0.02};
    EXPECT_NEAR(tolerance_error(*matrix, planar_variances(t)), 2 * error, 1e-12 * error);
    EXPECT_NEAR(worst_case(*matrix, planar_reach(t)), 2 * worst, 1e-12 * worst);
    EXPECT_GT(worst, error);
  }
}

TEST(ToleranceError, IsMadeUpOfShares) {
  const SensitivityMatrix matrix = function_matrix();
  const auto shares = variance_shares(matrix, planar_variances({.length = {1, 2, 3, 4, 5}, .driver = 0.01}));
  ASSERT_EQ(shares.size(), planar_parameters);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end(), [](auto& a, auto& b) { return a.share > b.share; }));
  double sum = 0;
  std::vector<double> per_position(matrix.positions());
  for (const auto& share : shares) {
    sum += share.share;
    for (std::size_t j = 0; j < per_position.size(); ++j) per_position[j] += share.per_position[j];
  }
  EXPECT_NEAR(sum, 1, 1e-14);
  for (const double whole : per_position) EXPECT_NEAR(whole, 1, 1e-14);
  // Without a parameter the error is what the other shares say.
  PlanarValues variances = planar_variances({.length = {1, 2, 3, 4, 5}, .driver = 0.01});
  const double whole = tolerance_error(matrix, variances);
  variances[shares[0].parameter] = 0;
  EXPECT_NEAR(tolerance_error(matrix, variances), whole * std::sqrt(1 - shares[0].share), 1e-12 * whole);
  // The point of a function generator does not matter.
  EXPECT_EQ(shares.back().share, 0);
  for (const auto& share : variance_shares(matrix, PlanarValues{})) EXPECT_EQ(share.share, 0);
}

// The largest of all corners of the box.
TEST(ToleranceError, IsAtWorstAtACorner) {
  const SensitivityMatrix matrix = function_matrix();
  const PlanarValues half = planar_half_tolerances({.length = {1, 2, 3, 4, 5}, .driver = 0.01});
  double worst = 0;
  for (unsigned corner = 0; corner < 1u << planar_parameters; ++corner)
    for (std::size_t j = 0; j < matrix.positions(); ++j) {
      double error = 0;
      for (std::size_t i = 0; i < planar_parameters; ++i)
        error += matrix.row(j, 0)[i] * (corner >> i & 1 ? half[i] : -half[i]);
      worst = std::max(worst, error);
    }
  EXPECT_NEAR(worst_case(matrix, half), worst, 1e-12);
}

// A linkage of each lane, all of which carry the body's origin through the same places.
struct Lanes {
  std::vector<std::vector<TracingFourBar>> positions{ToleranceErrorBlock::size};
  ToleranceErrorBlock block;
};

Lanes random_lanes(testing::RandomFourBars& random, const Tolerances& t, int positions) {
  Lanes lanes;
  ToleranceErrorBlock& block = lanes.block;
  const PlanarValues variances = planar_variances(t);
  block.variances = {variances[0], variances[1], variances[2], variances[3], variances[7], variances[9]};
  block.turning_length = *t.turning_length;
  block.positions = positions;
  std::vector<Pose> poses(static_cast<std::size_t>(positions));
  for (int j = 0; j < positions; ++j) {
    Pose& pose = poses[static_cast<std::size_t>(j)] = {{random.uniform(-2, 2), random.uniform(-2, 2)}, 0};
    block.point[j][0] = pose.origin.real();
    block.point[j][1] = pose.origin.imag();
  }
  for (int k = 0; k < ToleranceErrorBlock::size; ++k) {
    const LinkLengths lengths = random.lengths();
    const Point input_fixed{random.uniform(-2, 2), random.uniform(-2, 2)}, output_fixed = input_fixed + lengths.ground;
    for (int c = 0; c < 2; ++c) {
      block.input_fixed[c][k] = c == 0 ? input_fixed.real() : input_fixed.imag();
      block.output_fixed[c][k] = c == 0 ? output_fixed.real() : output_fixed.imag();
    }
    for (int j = 0; j < positions; ++j) {
      const FourBar bars = testing::four_bar_at(lengths, random.input_angle(lengths), random.assembly());
      const Point a = bars.input_moving + input_fixed, b = bars.output_moving + input_fixed;
      lanes.positions[static_cast<std::size_t>(k)].push_back(
          {{input_fixed, a, output_fixed, b}, poses[static_cast<std::size_t>(j)].origin});
      block.input_moving[j][0][k] = a.real();
      block.input_moving[j][1][k] = a.imag();
      block.output_moving[j][0][k] = b.real();
      block.output_moving[j][1][k] = b.imag();
    }
  }
  return lanes;
}

TEST(ToleranceError, IsThatOfTheKernel) {
  testing::RandomFourBars random(1513);
  int compared = 0;
  for (int n = 0; n < testing::draws(500); ++n) {
    const auto some = [&] { return random.below(3) == 0 ? 0 : random.uniform(0, 0.1); };
    Tolerances t{.length = {some(), some(), some(), some(), some()}, .clearance = some(), .driver = some()};
    t.turning_length = random.uniform(0, 2);
    Lanes lanes = random_lanes(random, t, 1 + random.below(ToleranceErrorBlock::most_positions));
    tolerance_error_kernel.scalar(lanes.block);
    for (std::size_t k = 0; k < lanes.positions.size(); ++k) {
      const auto matrix = sensitivities(pose_output(lanes.positions[k], *t.turning_length));
      if (!matrix) continue;
      ++compared;
      const double error = tolerance_error(*matrix, planar_variances(t));
      EXPECT_NEAR(lanes.block.error[k], error, 1e-6 * error);
    }
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
      if (!is_supported(simd)) continue;
      ToleranceErrorBlock other = lanes.block;
      tolerance_error_kernel.for_simd(simd)(other);
      for (int k = 0; k < ToleranceErrorBlock::size; ++k) EXPECT_EQ(other.error[k], lanes.block.error[k]) << name(simd);
    }
  }
  EXPECT_GT(compared, 10 * testing::draws(300));
}

TEST(ToleranceError, HasNoBoundAtADeadPoint) {
  testing::RandomFourBars random(1514);
  Lanes lanes = random_lanes(random, {.length = LengthTolerances::all(0.1), .turning_length = 1}, 2);
  ToleranceErrorBlock& block = lanes.block;
  for (int c = 0; c < 2; ++c)  // in lane 3 the coupler is a part of the output
    block.input_moving[1][c][3] = (block.output_moving[1][c][3] + block.output_fixed[c][3]) / 2;
  for (const Simd simd : {Simd::scalar, Simd::baseline, Simd::avx2, Simd::avx512}) {
    if (!is_supported(simd)) continue;
    tolerance_error_kernel.for_simd(simd)(block);
    for (int k = 0; k < ToleranceErrorBlock::size; ++k)
      if (k == 3)
        EXPECT_GT(block.error[k], 1e12);
      else
        EXPECT_TRUE(std::isfinite(block.error[k]));
  }
}

}  // namespace
}  // namespace linkwright::tolerance_error_test
