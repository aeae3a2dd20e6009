#include "robust/sampled_positions.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/mechanism/spherical_position.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
#include "support/random_four_bar.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::sampled_positions_test {
namespace {

constexpr std::size_t count = 300;

// By position and sample, as the errors of samples are given.
template <class Output, class Error>
void expect_errors(const Output& output, const Tolerances& tolerances, const Error& error) {
  const auto samples = sampled_positions(output, tolerances, count);
  const ErrorSamples expected = error_samples(output, tolerances, count);
  ASSERT_EQ(expected.errors.size(), output.positions.size());
  ASSERT_EQ(samples.size() + static_cast<std::size_t>(expected.not_assembled), count);
  for (std::size_t j = 0; j < output.positions.size(); ++j) {
    ASSERT_EQ(expected.errors[j].size(), samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k)
      EXPECT_NEAR(error(samples[k][j], output.positions[j]), expected.errors[j][k], 1e-9) << j << " " << k;
  }
}

std::vector<TracingFourBar> some_positions() {
  const FourBar bars = testing::four_bar_at({3, 1, 2.6, 2.4}, 0.4, Assembly::positive);
  const TracingFourBar linkage{bars, bars.input_moving + Point{1.2, 0.9}};
  std::vector<TracingFourBar> positions;
  for (int k = 0; k < 5; ++k)
    positions.push_back(linkage.moved_to(placed(bars, *assemble(bars.lengths(), 0.4 + 0.3 * k, Assembly::positive))));
  return positions;
}

double angle_between_points(Point a, Point b) { return std::abs(std::arg(b / a)); }

TEST(SampledPositions, OfPlanarLinkagesHaveTheErrorsOfTheSamples) {
  const auto positions = some_positions();
  for (const double size : {0.01, 0.4}) {
    const Tolerances t{.length = LengthTolerances::all(size), .clearance = size / 2, .driver = size};
    expect_errors(pose_output(positions, 2), t, [](const TracingFourBar& is, const TracingFourBar& was) {
      const FourBar &a = is.bars, &b = was.bars;
      const double turn = angle_between_points(a.output_moving - a.input_moving, b.output_moving - b.input_moving);
      return std::hypot(std::abs(is.point - was.point), 2 * turn);
    });
    const DirectedLine line{{0.5, 1}, direction(0.3)};
    expect_errors(line_output(positions, line, false), t,
                  [&](const TracingFourBar& is, const TracingFourBar&) { return line.to_line(is.point).imag(); });
  }
}

SphericalOutput sphere(SphericalOutput::Kind kind) {
  const LinkAngles angles{1.3, 0.5, 1.1, 0.9};
  const auto on_arc = [](double angle) { return Vector3{std::sin(angle), 0, std::cos(angle)}; };
  SphericalOutput output{kind, {}};
  for (const double input : {0.3, 1.2, 2.5})
    output.positions.push_back(
        placed({on_arc(0), on_arc(angles.input), on_arc(angles.ground + angles.output), on_arc(angles.ground)},
               *assemble(angles, input, Assembly::negative)));
  return output;
}

TEST(SampledPositions, OfSphericalLinkagesHaveTheErrorsOfTheSamples) {
  for (const double size : {0.01, 0.4}) {
    const Tolerances t{.driver = size, .link_angle = size};
    expect_errors(sphere(SphericalOutput::Kind::angle), t, [](const SphericalFourBar& is, const SphericalFourBar& was) {
      return std::abs(wrap_signed(configuration_of(is).output_angle - configuration_of(was).output_angle));
    });
    const auto samples = sampled_positions(sphere(SphericalOutput::Kind::orientation), t, count);
    const auto deviations = sampled_deviations(SphericalOutput{}, t, count);
    // They have the arcs that were made, in the same assembly, all of unit length.
    if (samples.size() < count) continue;
    for (std::size_t k = 0; k < count; ++k)
      for (const SphericalFourBar& bars : samples[k]) {
        const LinkAngles made = bars.angles();
        EXPECT_NEAR(made.input, 0.5 + deviations[k][0], 1e-12);
        EXPECT_NEAR(made.coupler, 1.1 + deviations[k][1], 1e-12);
        EXPECT_NEAR(made.output, 0.9 + deviations[k][2], 1e-12);
        EXPECT_NEAR(made.ground, 1.3 + deviations[k][3], 1e-12);
        EXPECT_NEAR(norm(bars.output_moving), 1, 1e-12);
        EXPECT_EQ(assembly_of(bars), Assembly::negative);
      }
  }
}

TEST(SampledPositions, OfSixBarsHaveTheErrorsAndLengthsOfTheSamples) {
  std::mt19937_64 random(1551);
  for (const SixBarRow& row : six_bar_rows()) {
    const auto [task, member] = testing::random_six_bar(random, row);
    SixBarOutput output{member.six_bar, {}, task.poses[0].pose, 2};
    for (const SixBarTurns& turns : member.turns)
      if (const auto exact = closed(output.six_bar, turns)) output.positions.push_back(*exact);
    const Tolerances t{.length = LengthTolerances::all(0.01), .clearance = 0.002, .driver = 0.01};
    expect_errors(output, t, [&](const SampledSixBar& is, const SixBarTurns& was) {
      const Pose nominal = guided_pose(output.six_bar, was, output.reference);
      return std::hypot(std::abs(is.guided.origin - nominal.origin),
                        2 * std::abs(wrap_signed(is.guided.angle - nominal.angle)));
    });
    const auto samples = sampled_positions(output, t, count);
    const auto lengths = output.six_bar.lengths();
    for (const auto& positions : samples)
      for (const SixBarLength& length : lengths) {
        if (length.body == 0) continue;
        const auto made = [&](const SampledSixBar& at) {
          return std::abs(at.joints[length.joints[1]] - at.joints[length.joints[0]]);
        };
        for (const SampledSixBar& at : positions) EXPECT_NEAR(made(at), made(positions[0]), 1e-9);
        EXPECT_NEAR(made(positions[0]), length.length, 0.05);
      }
  }
}

// What is counted adds up to what is sampled.
TEST(SampledPositions, ErrorsOfSamplesAreThoseOfTheFigures) {
  Tolerances t{.length = LengthTolerances::all(0.02)};
  t.samples = 1000;
  const PlanarOutput output = pose_output(some_positions(), 1);
  const SampledErrors figures = sample_errors(output, t);
  const ErrorSamples samples = error_samples(output, t, 1000);
  for (std::size_t j = 0; j < samples.errors.size(); ++j) {
    double squares = 0;
    for (const double error : samples.errors[j]) squares += error * error;
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(samples.errors[j].size())), figures.deviations[j], 1e-12);
  }
  EXPECT_EQ(samples.not_assembled, figures.not_assembled);
}

}  // namespace
}  // namespace linkwright::sampled_positions_test
