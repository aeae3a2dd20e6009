#include "linkwright/mechanism/spherical_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "linkwright/spherical/axis_curve.hpp"
#include "support/attitude_case.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_analysis_test {
namespace {

SphericalFourBar random_bars(std::mt19937_64& random) { return testing::random_spherical_four_bar(random); }

TEST(SphericalAnalysis, MotionRunsOverTheRangeAndKeepsTheLinks) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const SphericalAnalysis analysis = analyze(bars);
    ASSERT_EQ(analysis.motion.size(), 361u) << i;
    EXPECT_NEAR(analysis.motion.front().configuration.input_angle, analysis.input_range.from, 1e-12);
    EXPECT_GE(analysis.configuration.input_angle, analysis.input_range.from - 1e-9);
    EXPECT_LE(analysis.configuration.input_angle, analysis.input_range.to + 1e-9);
    for (const SphericalState& state : analysis.motion) {
      EXPECT_LT(norm(state.turn.apply(bars.input_moving) - state.four_bar.input_moving), 1e-12);
      EXPECT_LT(norm(state.turn.apply(bars.output_moving) - state.four_bar.output_moving), 3e-6);
    }
  }
}

TEST(SphericalAnalysis, RockersEndAtTheirDeadPoints) {
  std::mt19937_64 random(2);
  int rockers = 0;
  for (int i = 0; i < 100; ++i) {
    const SphericalAnalysis analysis = analyze(random_bars(random));
    if (input_is_crank(analysis.type)) {
      EXPECT_TRUE(analysis.dead_points.empty());
      EXPECT_TRUE(analysis.input_range.is_full_turn());
      double least = pi;
      for (const SphericalState& state : analysis.motion) least = std::min(least, state.transmission_angle);
      EXPECT_NEAR(least, analysis.min_transmission_angle, 1e-2);
      EXPECT_GE(least, analysis.min_transmission_angle - 1e-9);
    } else {
      ++rockers;
      EXPECT_LT(analysis.motion.front().transmission_angle, 1e-5);
      EXPECT_LT(analysis.motion.back().transmission_angle, 1e-5);
      EXPECT_EQ(analysis.min_transmission_angle, 0);
    }
  }
  EXPECT_GT(rockers, 20);
}

// One arc is the sum of the others: the input cannot move, and rounding may leave it no range at all.
TEST(SphericalAnalysis, AStretchedLinkageHasItsPlaceAsRange) {
  int without_range = 0;
  for (int input = 1; input <= 11; ++input)
    for (int coupler = 1; coupler <= 11; ++coupler)
      for (int output = 1; output <= 11; ++output) {
        const auto axis_at = [](int steps) {
          return Vector3{std::cos(radians(5.0 * steps)), std::sin(radians(5.0 * steps)), 0};
        };
        const SphericalFourBar bars{axis_at(0), axis_at(input), axis_at(input + coupler),
                                    axis_at(input + coupler + output)};
        without_range += input_ranges(bars.angles()).empty();
        const SphericalAnalysis analysis = analyze(bars);
        EXPECT_LE(analysis.input_range.from, analysis.configuration.input_angle + 1e-6);
        EXPECT_GE(analysis.input_range.to, analysis.configuration.input_angle - 1e-6);
      }
  EXPECT_GT(without_range, 0);
}

// The orientations of a task that a linkage does without defects all lie on its drive, in order.
TEST(SphericalAnalysis, MeetsTheOrientationsOfItsTask) {
  const auto wing = testing::spherical_case("folding-wing-4");
  const AxisCurve curve(orientation_conditions(wing.orientations));
  int looked_at = 0;
  for (double a = 0.02; a < 1; a += 0.03)
    for (double b = 0.01; b < 1; b += 0.03) {
      const SphericalDyad p = curve.dyad(a), q = curve.dyad(b);
      const SphericalFourBar bars{p.fixed_axis, p.moving_axis, q.moving_axis, q.fixed_axis};
      const DefectReport report = find_defects(bars, wing.orientations);
      if (!report.defects.none() || report.min_transmission_angle < 0.1) continue;
      ++looked_at;
      std::vector<int> met;
      for (const SphericalState& state : analyze(bars, wing.orientations).motion)
        if (state.position) {
          met.push_back(*state.position);
          const UnitQuaternion turn = wing.orientations[static_cast<std::size_t>(*state.position) - 1].orientation *
                                      wing.orientations[0].orientation.inverse();
          EXPECT_LT(angle_between(state.turn, turn), 1e-6);
        }
      EXPECT_EQ(met.size(), 4u);
    }
  EXPECT_GT(looked_at, 20);
}

TEST(SphericalAnalysis, ExtremesAreThoseOfManySteps) {
  constexpr int steps = 20'000;
  std::mt19937_64 random(7);
  int cranks = 0;
  for (int i = 0; i < 40; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const SphericalAnalysis analysis = analyze(bars), dense = analyze(bars, {}, steps);
    double peak = 0, least = 1e300, most = -1e300;
    for (const SphericalState& state : dense.motion) {
      peak = std::max(peak, state.transmission_angle);
      if (!state.velocity_ratio) continue;
      least = std::min(least, *state.velocity_ratio);
      most = std::max(most, *state.velocity_ratio);
    }
    EXPECT_GE(analysis.largest_transmission.angle, peak - 1e-9) << i;
    EXPECT_NEAR(analysis.largest_transmission.angle, peak, 5e-3) << i;
    EXPECT_EQ(analysis.velocity_ratios.has_value(), input_is_crank(analysis.type)) << i;
    if (!analysis.velocity_ratios) continue;
    ++cranks;
    EXPECT_LE(analysis.velocity_ratios->least, least + 1e-9 * (most - least)) << i;
    EXPECT_GE(analysis.velocity_ratios->most, most - 1e-9 * (most - least)) << i;
    EXPECT_NEAR(analysis.velocity_ratios->least, least, 1e-3 * (most - least)) << i;
    EXPECT_NEAR(analysis.velocity_ratios->most, most, 1e-3 * (most - least)) << i;
  }
  EXPECT_GT(cranks, 2);
}

TEST(SphericalAnalysis, MovesAsItIsWhereItMissesAnOrientation) {
  const auto [bars, orientations] = [] {
    std::mt19937_64 random(3);
    const SphericalFourBar drawn = random_bars(random);
    const SphericalAnalysis drive = analyze(drawn);
    std::vector<PrescribedOrientation> wanted;
    for (const std::size_t row : {std::size_t{180}, std::size_t{200}, std::size_t{230}})
      wanted.push_back({drive.motion[row].turn, {}});
    return std::pair(drive.motion[180].four_bar, wanted);
  }();
  constexpr double off = 0.01;
  std::vector<PrescribedOrientation> missed = orientations;
  missed[1].orientation = UnitQuaternion::about({0, 0, 1}, off) * missed[1].orientation;
  const SphericalAnalysis analysis = analyze(bars, missed);
  int positions = 0;
  for (const SphericalState& state : analysis.motion) {
    EXPECT_NEAR(angle_between(state.four_bar.input_moving, state.four_bar.output_moving), analysis.angles.coupler,
                1e-9);
    if (!state.position) continue;
    ++positions;
    if (*state.position == 2) {
      EXPECT_GT(state.orientation_error, 1e-4);
      EXPECT_LE(state.orientation_error, off + 1e-9);
    } else {
      EXPECT_LT(state.orientation_error, 1e-7);
    }
  }
  EXPECT_EQ(positions, 3);
}

TEST(SphericalAnalysis, PathBelongsToAnAxisOfTheCoupler) {
  std::mt19937_64 random(3);
  const SphericalFourBar bars = random_bars(random);
  const SphericalAnalysis analysis = analyze(bars);
  const auto path = coupler_path(analysis, bars.input_moving);
  ASSERT_EQ(path.size(), analysis.motion.size());
  for (std::size_t k = 0; k < path.size(); ++k)
    EXPECT_LT(norm(path[k] - analysis.motion[k].four_bar.input_moving), 1e-12);
}

TEST(SphericalAnalysis, NoLinkageHasNoMotion) {
  const SphericalAnalysis analysis = analyze({{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(analysis.type, LinkageType::degenerate);
  EXPECT_TRUE(analysis.motion.empty());
}

}  // namespace
}  // namespace linkwright::spherical_analysis_test
