#include "linkwright/mechanism/spherical_position.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "support/attitude_case.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::spherical_position_test {
namespace {

using testing::random_direction;

SphericalFourBar random_bars(std::mt19937_64& random) { return testing::random_spherical_four_bar(random, 0.1); }

double apart(const LinkAngles& a, const LinkAngles& b) {
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, std::abs(a.all()[i] - b.all()[i]));
  return worst;
}

TEST(SphericalPosition, AssemblesWhereItLies) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const SphericalConfiguration here = configuration_of(bars);
    const auto found = assemble(bars.angles(), here.input_angle, assembly_of(bars));
    ASSERT_TRUE(found);
    EXPECT_NEAR(wrap_signed(found->output_angle - here.output_angle), 0, 1e-6);
    const SphericalFourBar back = placed(bars, *found);
    EXPECT_LT(norm(back.input_moving - bars.input_moving), 1e-13);
    EXPECT_LT(norm(back.output_moving - bars.output_moving), 1e-6);
  }
}

TEST(SphericalPosition, LinksKeepTheirAnglesOnTheWay) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    const SphericalFourBar bars = random_bars(random);
    for (const AngleRange& range : input_ranges(bars.angles()))
      for (int k = 0; k <= 20; ++k) {
        const double input = range.from + (range.to - range.from) * k / 20;
        for (const Assembly assembly : {Assembly::positive, Assembly::negative}) {
          const auto there = assemble(bars.angles(), input, assembly);
          ASSERT_TRUE(there) << i << " " << k;
          EXPECT_LT(apart(placed(bars, *there).angles(), bars.angles()), 2e-7);
        }
      }
  }
}

// By the equation A cos ψ + B sin ψ = C of the loop, which the triangle does not use.
TEST(SphericalPosition, SolvesTheLoopEquation) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const LinkAngles l = random_bars(random).angles();
    for (double theta = -3; theta < 3.2; theta += 0.4)
      if (const auto there = assemble(l, theta, Assembly::positive)) {
        const double s1 = std::sin(l.input), s3 = std::sin(l.output), s4 = std::sin(l.ground), c1 = std::cos(l.input),
                     c3 = std::cos(l.output), c4 = std::cos(l.ground);
        const double a = s3 * (s1 * c4 * std::cos(theta) - c1 * s4), b = s3 * s1 * std::sin(theta),
                     c = std::cos(l.coupler) - c3 * (c1 * c4 + s1 * s4 * std::cos(theta));
        EXPECT_NEAR(a * std::cos(there->output_angle) + b * std::sin(there->output_angle), c, 1e-13);
      }
  }
}

TEST(SphericalPosition, RangesEndAtDeadPointsAndNowhereElse) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 500; ++i) {
    const LinkAngles l = random_bars(random).angles();
    const auto ranges = input_ranges(l);
    const auto ends = dead_points(l);
    const bool crank = input_is_crank(linkage_type(l));
    EXPECT_EQ(crank, ends.empty());
    for (int k = 0; k < 200; ++k) {
      const double input = -pi + two_pi * (k + 0.5) / 200;
      const bool inside = std::ranges::any_of(ranges, [&](const AngleRange& range) {
        return (input >= range.from && input <= range.to) ||
               (input + two_pi >= range.from && input + two_pi <= range.to);
      });
      EXPECT_EQ(assemble(l, input, Assembly::positive).has_value(), inside);
    }
    for (const SphericalDeadPoint& end : ends) {
      const auto one = assemble(l, end.configuration.input_angle, Assembly::positive),
                 other = assemble(l, end.configuration.input_angle, Assembly::negative);
      ASSERT_TRUE(one && other);
      EXPECT_NEAR(wrap_signed(one->output_angle - other->output_angle), 0, 1e-6);
    }
  }
}

TEST(SphericalPosition, CouplerTurnCarriesBothMovingAxes) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 200; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const auto ranges = input_ranges(bars.angles());
    const auto there = assemble(bars.angles(), 0.3 * ranges[0].from + 0.7 * ranges[0].to, Assembly::negative);
    ASSERT_TRUE(there);
    const SphericalFourBar moved = placed(bars, *there);
    const UnitQuaternion turn = coupler_turn(bars, moved);
    EXPECT_LT(norm(turn.apply(bars.input_moving) - moved.input_moving), 1e-13);
    EXPECT_LT(norm(turn.apply(bars.output_moving) - moved.output_moving), 1e-6);
  }
}

TEST(SphericalPosition, VelocityRatioIsTheSlope) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 300; ++i) {
    const SphericalFourBar bars = random_bars(random);
    if (transmission_angle(bars) < 0.1) continue;
    const double input = configuration_of(bars).input_angle, step = 1e-5;
    const auto ahead = assemble(bars.angles(), input + step, assembly_of(bars)),
               back = assemble(bars.angles(), input - step, assembly_of(bars));
    const auto ratio = velocity_ratio(bars);
    if (!ahead || !back) continue;
    ASSERT_TRUE(ratio);
    EXPECT_NEAR(*ratio, wrap_signed(ahead->output_angle - back->output_angle) / (2 * step),
                1e-5 * (1 + *ratio * *ratio));
  }
}

// The angle at the output's moving joint by the cosine rule.
TEST(SphericalPosition, TransmissionAngleFollowsTheCosineRule) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 500; ++i) {
    const SphericalFourBar bars = random_bars(random);
    const LinkAngles l = bars.angles();
    const double diagonal = angle_between(bars.input_moving, bars.output_fixed);
    const double cosine =
        (std::cos(diagonal) - std::cos(l.coupler) * std::cos(l.output)) / (std::sin(l.coupler) * std::sin(l.output));
    EXPECT_NEAR(std::cos(transmission_angle(bars)), std::abs(cosine), 1e-12);
  }
}

// A universal joint: three right angles; tan ψ = tan θ / cos(bend), from the right datum.
TEST(SphericalPosition, UniversalJointTurnsAsItsFormulaSays) {
  const double bend = radians(30);
  const LinkAngles l{pi - bend, pi / 2, pi / 2, pi / 2};
  ASSERT_EQ(input_ranges(l).size(), 1u);
  EXPECT_TRUE(input_ranges(l)[0].is_full_turn());
  const auto first = assemble(l, 0, Assembly::positive);
  ASSERT_TRUE(first);
  for (double theta = 0.1; theta < 6.2; theta += 0.1) {
    const auto there = assemble(l, theta, Assembly::positive);
    ASSERT_TRUE(there);
    const double turn = there->output_angle - first->output_angle;
    const double ratio_of_tangents = std::abs(std::tan(turn) / std::tan(theta));
    EXPECT_NEAR(ratio_of_tangents, std::abs(std::cos(theta)) > 1e-3 ? 1 / std::cos(bend) : ratio_of_tangents, 1e-9)
        << theta;
  }
}

SphericalFourBar bars_of(const LinkAngles& l, double input_angle) {
  const SphericalFourBar reference{{0, 0, 1},
                                   {std::sin(l.input), 0, std::cos(l.input)},
                                   {std::sin(l.ground - l.output), 0, std::cos(l.ground - l.output)},
                                   {std::sin(l.ground), 0, std::cos(l.ground)}};
  SphericalFourBar bars = reference;
  const auto there = assemble(l, input_angle, Assembly::positive);
  // placed() takes the links from its reference: tilt the output arm until the coupler fits.
  bars.input_moving = {std::sin(l.input) * std::cos(input_angle), std::sin(l.input) * std::sin(input_angle),
                       std::cos(l.input)};
  const double psi = there->output_angle, s = std::sin(l.output), c = std::cos(l.output);
  const Vector3 seen{std::cos(psi) * s, std::sin(psi) * s, c};
  bars.output_moving = {std::cos(l.ground) * seen.x + std::sin(l.ground) * seen.z, seen.y,
                        std::cos(l.ground) * seen.z - std::sin(l.ground) * seen.x};
  return bars;
}

std::vector<PrescribedOrientation> orientations_on_the_way(const SphericalFourBar& bars,
                                                           std::initializer_list<double> inputs) {
  std::vector<PrescribedOrientation> found;
  for (const double input : inputs) {
    const auto there = assemble(bars.angles(), input, assembly_of(bars));
    found.push_back({coupler_turn(bars, placed(bars, *there)), {}});
  }
  return found;
}

TEST(SphericalDrive, CrankMeetsWhatLiesOnItsWay) {
  const SphericalFourBar bars = bars_of({radians(70), radians(20), radians(65), radians(50)}, 0.2);
  const auto report = drive_through(bars, orientations_on_the_way(bars, {0.2, 1.5, 3, 5}));
  EXPECT_TRUE(report.completed);
  EXPECT_TRUE(report.defects.none());
  EXPECT_EQ(report.visited, (std::vector{0, 1, 2, 3}));
  EXPECT_LT(report.worst_pose_error, 1e-12);
}

TEST(SphericalDrive, OutOfOrderIsAnOrderDefect) {
  const SphericalFourBar bars = bars_of({radians(70), radians(20), radians(65), radians(50)}, 0.2);
  const auto report = drive_through(bars, orientations_on_the_way(bars, {0.2, 3, 1.5, 5}));
  EXPECT_EQ(report.defects, Defects{Defects::order_bit});
}

TEST(SphericalDrive, OtherAssemblyOfACrankIsAnotherCircuit) {
  const SphericalFourBar bars = bars_of({radians(70), radians(20), radians(65), radians(50)}, 0.2);
  auto asked = orientations_on_the_way(bars, {0.2, 1.5});
  const auto other = assemble(bars.angles(), 2.5, Assembly::negative);
  asked.push_back({coupler_turn(bars, placed(bars, *other)), {}});
  EXPECT_TRUE(drive_through(bars, asked).defects.circuit());
}

TEST(SphericalDrive, BeyondADeadPointIsABranchDefect) {
  const LinkAngles links{radians(70), radians(40), radians(30), radians(50)};  // a triple rocker about 0
  const auto range = input_ranges(links).front();
  const SphericalFourBar bars = bars_of(links, 0.5 * range.to);
  auto asked = orientations_on_the_way(bars, {0.5 * range.to});
  const auto other = assemble(links, 0.7 * range.to, Assembly::negative);
  asked.push_back({coupler_turn(bars, placed(bars, *other)), {}});
  const auto report = drive_through(bars, asked);
  EXPECT_TRUE(report.completed);
  EXPECT_EQ(report.defects, Defects{Defects::branch_bit});
}

TEST(SphericalDrive, NoLinkageIsNotDriven) {
  EXPECT_FALSE(
      drive_through({{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, std::vector<PrescribedOrientation>(1)).completed);
}

}  // namespace
}  // namespace linkwright::spherical_position_test
