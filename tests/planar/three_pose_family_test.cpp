#include "planar/three_pose_family.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "linkwright/core/angle.hpp"
#include "support/random_task.hpp"

namespace linkwright::three_pose_family_test {
namespace {

using testing::uniform;

const std::vector<PrescribedPose> general_poses = {{{{0, 0}, 0}, {}}, {{{1.5, 0.6}, 0.5}, {}}, {{{2.6, 1.9}, 1.2}, {}}};
const std::vector<PrescribedPose> shifted_poses = {{{{0, 0}, 0}, {}}, {{{1.5, 0.6}, 0}, {}}, {{{2.6, 1.9}, 1.2}, {}}};

std::shared_ptr<const ThreePoseDyads> dyads_of(const PoseConditions& conditions) {
  return std::make_shared<const ThreePoseDyads>(conditions);
}

SideLengthsFamily lengths_family(const std::vector<PrescribedPose>& poses, double input, double output) {
  const PoseConditions conditions = pose_conditions(poses);
  return {conditions.frame, poses, dyads_of(conditions), input, output};
}

SideAngleFamily angle_family(const std::vector<PrescribedPose>& poses, double angle, bool directed, double input) {
  const PoseConditions conditions = pose_conditions(poses);
  return {conditions.frame, poses, dyads_of(conditions), angle, directed, input};
}

FourBar user_bars(const FourBarFamily& family, const DyadPair& links) {
  const FourBar bars = four_bar_of(links).value();
  const WorkingFrame& frame = family.frame();
  return {frame.to_user(bars.input_fixed), frame.to_user(bars.input_moving), frame.to_user(bars.output_fixed),
          frame.to_user(bars.output_moving)};
}

double residual(const std::vector<PrescribedPose>& poses, Point center, Point circle) {
  double worst = 0;
  for (const PrescribedPose& pose : poses)
    worst = std::max(
        worst,
        std::abs(std::abs(displaced(circle, poses[0].pose, pose.pose) - center) / std::abs(circle - center) - 1));
  return worst;
}

Point input_arm(const FourBar& bars) { return bars.input_moving - bars.input_fixed; }
Point output_arm(const FourBar& bars) { return bars.output_moving - bars.output_fixed; }

TEST(SideLengthsFamily, KeepsBothLengthsAndTheDirectionsOnItsAxes) {
  const auto family = lengths_family(general_poses, 2, 1.7);
  EXPECT_EQ(family.axis(Side::input).quantity, AxisQuantity::side_direction);
  EXPECT_EQ(family.axis(Side::output).branches.size(), 2u);
  EXPECT_FALSE(family.is_symmetric());
  EXPECT_TRUE(lengths_family(general_poses, 2, 2).is_symmetric());
  int found = 0;
  for (const double u : family.samples(Side::input, 20, Spacing::coordinate))
    for (const double v : family.samples(Side::output, 20, Spacing::coordinate)) {
      const auto links = family.dyad_pair({u, v});
      ASSERT_TRUE(links);
      const FourBar bars = user_bars(family, *links);
      EXPECT_NEAR(bars.lengths().input, 2, 1e-12);
      EXPECT_NEAR(bars.lengths().output, 1.7, 1e-12);
      EXPECT_NEAR(std::remainder(std::arg(input_arm(bars)) - radians(family.axis_value(Side::input, u)), two_pi), 0,
                  1e-12);
      EXPECT_LT(residual(general_poses, bars.output_fixed, bars.output_moving), 1e-12);
      ++found;
    }
  EXPECT_EQ(found, 400);
}

TEST(SideLengthsFamily, SheetsHaveTheSameDirections) {
  const auto family = lengths_family(general_poses, 2, 2);
  const auto samples = family.samples(Side::input, 80, Spacing::coordinate);
  ASSERT_EQ(samples.size(), 80u);
  EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end()));
  for (std::size_t i = 0; i < 40; ++i) EXPECT_NEAR(samples[i] + 1, samples[i + 40], 1e-15);
  // There are none between about 180° and 270°, and none are laid there.
  for (const double tau : samples) EXPECT_FALSE(tau > 0.5 && tau < 0.75) << tau;
  EXPECT_FALSE(family.dyad_pair({0.6, 0.1}));
}

TEST(SideLengthsFamily, SmallTurnsFillTheMapToo) {
  std::vector<PrescribedPose> poses = general_poses;
  for (PrescribedPose& pose : poses) pose.pose.angle *= 1e-3;
  const auto family = lengths_family(poses, 2, 2);
  RegionMap map;
  const auto samples = family.samples(Side::input, 50, Spacing::coordinate);
  family.classify(map, samples, samples, true, {}, {});
  const RegionCounts counts = map.counts();
  EXPECT_EQ(counts.pairs, 50 * 49);
  EXPECT_LT(counts.types[static_cast<std::size_t>(LinkageType::degenerate)], 50);
}

TEST(SideLengthsFamily, OneShiftLeavesTheCirclesOfCentres) {
  const auto family = lengths_family(shifted_poses, 2, 3);
  EXPECT_EQ(family.axis(Side::input).quantity, AxisQuantity::curve_coordinate);
  ASSERT_EQ(family.axis(Side::input).branches.size(), 2u);
  int found = 0;
  for (const double u : family.samples(Side::input, 12, Spacing::coordinate))
    for (const double v : family.samples(Side::output, 12, Spacing::coordinate)) {
      const auto links = family.dyad_pair({u, v});
      if (!links) continue;
      const FourBar bars = user_bars(family, *links);
      EXPECT_NEAR(bars.lengths().input, 2, 1e-12);
      EXPECT_LT(residual(shifted_poses, bars.input_fixed, bars.input_moving), 1e-13);
      EXPECT_LT(residual(shifted_poses, bars.output_fixed, bars.output_moving), 1e-13);
      ++found;
    }
  EXPECT_EQ(found, 144);
}

TEST(SideLengthsFamily, HasNothingWhereNoDyadHasTheLength) {
  const auto family = lengths_family(shifted_poses, 0.1, 2);
  EXPECT_FALSE(family.dyad_pair({0.3, 0.3}));
  EXPECT_TRUE(family.polygon(Side::input).empty());
  EXPECT_FALSE(family.polygon(Side::output).empty());
}

class SideAngle : public ::testing::TestWithParam<bool> {};

TEST_P(SideAngle, IsKeptByEveryFourBar) {
  const bool directed = GetParam();
  std::mt19937_64 random(3);
  int found = 0, opposite = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const double angle = uniform(random, -pi, pi), length = uniform(random, 0.5, 2);
    const auto family = angle_family(poses, angle, directed, length);
    EXPECT_EQ(family.axis(Side::output).branches.size(), directed ? 2u : 4u);
    for (const double u : family.samples(Side::input, 8, Spacing::coordinate))
      for (const double v : family.samples(Side::output, 40, Spacing::coordinate)) {
        const auto links = family.dyad_pair({u, v});
        if (!links) continue;
        const FourBar bars = user_bars(family, *links);
        const double size = std::abs(bars.output_fixed) + std::abs(bars.input_fixed);
        EXPECT_NEAR(bars.lengths().input / length, 1, 1e-13 * (1 + size / length));
        EXPECT_NEAR(bars.lengths().output / family.axis_value(Side::output, v), 1,
                    1e-13 * (1 + size / bars.lengths().output));
        const double between = std::arg(output_arm(bars) / input_arm(bars)) - angle;
        EXPECT_NEAR(std::remainder(between, directed ? two_pi : pi), 0, 1e-12 * (1 + size / bars.lengths().output));
        opposite += std::abs(std::remainder(between, two_pi)) > 1;
        ++found;
      }
  }
  EXPECT_GT(found, 500);
  EXPECT_EQ(opposite > 0, !directed);
}

INSTANTIATE_TEST_SUITE_P(DirectedOrNot, SideAngle, ::testing::Bool());

// The two families cut the same four-bars: one of given lengths has an angle, and the family of that angle has it.
TEST(SideAngleFamily, FindsTheFourBarsOfGivenLengths) {
  std::mt19937_64 random(7);
  int found = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto poses = testing::random_poses(random, 3);
    const auto lengths = lengths_family(poses, 1.3, 0.8);
    const auto input = lengths.samples(Side::input, 4, Spacing::coordinate),
               output = lengths.samples(Side::output, 4, Spacing::coordinate);
    for (const double u : input)
      for (const double v : output) {
        const auto links = lengths.dyad_pair({u, v});
        if (!links) continue;
        const double angle = two_pi * (v - u);
        const auto family = angle_family(poses, angle, true, 1.3);
        const double place = std::floor(v) + 2 / pi * std::atan2(0.8, 1.3);
        const auto same = family.dyad_pair({u, place});
        ASSERT_TRUE(same);
        EXPECT_LT(std::abs(*finite_point(same->output.center) - *finite_point(links->output.center)), 1e-6);
        ++found;
      }
  }
  EXPECT_GT(found, 100);
}

TEST(SideAngleFamily, ClassifiesEachCellAsAloneItWouldBe) {
  const auto family = angle_family(general_poses, 0.7, false, 2);
  const auto input = family.samples(Side::input, 30, Spacing::coordinate),
             output = family.samples(Side::output, 40, Spacing::coordinate);
  RegionMap map;
  family.classify(map, input, output, true, {}, {});
  int compared = 0;
  for (std::size_t row = 0; row < input.size(); ++row)
    for (std::size_t column = 0; column < output.size(); ++column) {
      const auto links = family.dyad_pair({input[row], output[column]});
      const auto bars = links ? four_bar_of(*links) : std::nullopt;
      const std::size_t cell = map.index(row, column);
      if (!bars) {
        EXPECT_EQ(map.type(cell), LinkageType::degenerate);
        continue;
      }
      const DefectReport report = find_defects(*bars, family.working_poses({input[row], output[column]}, *bars), true);
      EXPECT_EQ(map.type(cell), report.type);
      EXPECT_EQ(map.defects(cell).bits, report.defects.bits);
      ++compared;
    }
  EXPECT_GT(compared, 100);
}

TEST(SideAngleFamily, OneShiftTakesTheLengthFromTheDirection) {
  const auto family = angle_family(shifted_poses, 0.4, false, 2);
  EXPECT_EQ(family.axis(Side::output).quantity, AxisQuantity::curve_coordinate);
  int found = 0;
  for (const double u : family.samples(Side::input, 10, Spacing::coordinate))
    for (const double v : family.samples(Side::output, 10, Spacing::coordinate)) {
      const auto links = family.dyad_pair({u, v});
      if (!links) continue;
      const FourBar bars = user_bars(family, *links);
      EXPECT_LT(residual(shifted_poses, bars.output_fixed, bars.output_moving), 1e-12);
      EXPECT_NEAR(std::remainder(std::arg(output_arm(bars) / input_arm(bars)) - 0.4, pi), 0, 1e-12);
      ++found;
    }
  EXPECT_GT(found, 0);
}

TEST(SideAngleFamily, DrawsTheInputsCurveOnly) {
  const auto family = angle_family(general_poses, 0.7, true, 2);
  EXPECT_GT(family.polygon(Side::input).size(), 500u);
  EXPECT_TRUE(family.polygon(Side::output).empty());
}

}  // namespace
}  // namespace linkwright::three_pose_family_test
