#include "linkwright/spherical/spherical_drive.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/spherical/spherical_position.hpp"

namespace linkwright::spherical_drive_test {
namespace {

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
}  // namespace linkwright::spherical_drive_test
