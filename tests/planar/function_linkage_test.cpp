#include "planar/function_linkage.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/drive_table.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/position.hpp"
#include "planar/function_couplers.hpp"
#include "support/random_four_bar.hpp"
#include "support/random_function.hpp"
#include "support/random_task.hpp"

namespace linkwright::function_linkage_test {
namespace {

using testing::uniform;

Point output_arm_turned(const FourBar& bars, const AnglePair& first, const AnglePair& pair) {
  return bars.output_fixed + direction(pair.output - first.output) * (bars.output_moving - bars.output_fixed);
}

std::optional<FourBar> linkage_at(const FunctionTask& task, double tau) {
  const FunctionCouplers couplers = function_couplers(task);
  const auto coupler = couplers.coupler(tau);
  return coupler ? function_four_bar(task, couplers.frame(), *coupler) : std::nullopt;
}

TEST(FunctionLinkage, TheCouplerIsWhereTheArmsAre) {
  std::mt19937_64 random(1);
  int linkages = 0;
  for (int i = 0; i < 500; ++i) {
    const auto pairs = testing::random_pairs(random, {1, 1, 1, 1});
    const auto bars = linkage_at({{pairs, {}, {}}, {2, 1}, {0, 4}}, uniform(random, 0, 1));
    if (!bars || bars->lengths().coupler < 1e-2) continue;
    const auto poses = coupler_poses(*bars, pairs);
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      const double size = bars->lengths().perimeter();
      EXPECT_NEAR(std::abs(displaced(bars->input_moving, poses[0].pose, poses[j].pose) - bars->input_fixed -
                           direction(pairs[j].input - pairs[0].input) * (bars->input_moving - bars->input_fixed)),
                  0, 1e-13 * size);
      EXPECT_NEAR(std::abs(displaced(bars->output_moving, poses[0].pose, poses[j].pose) -
                           output_arm_turned(*bars, pairs[0], pairs[j])),
                  0, 1e-9 * size);
    }
    ++linkages;
  }
  EXPECT_GT(linkages, 400);
}

// Four-bars that are driven give pairs with derivatives, and the coupler's are known from its own kinematics.
TEST(FunctionLinkage, TheCouplersRatesAreThoseOfADrivenFourBar) {
  testing::RandomFourBars random(2);
  for (int i = 0; i < 200; ++i) {
    const FourBar bars = random.four_bar();
    const LinkLengths lengths = bars.lengths();
    const Configuration start = configuration_of(bars);
    const double to = random.input_angle(lengths);
    const auto there = assemble(lengths, to, assembly_of(bars));
    ASSERT_TRUE(there);
    const auto rates = angle_rates(lengths, *there);
    if (!rates || std::abs(rates->output) > 20) continue;
    const std::vector<AnglePair> pairs = {
        {start.input_angle, start.output_angle, {}},
        {to, there->output_angle, {{1, rates->output}, {0, rates->output_acceleration}}}};
    const auto poses = coupler_poses(bars, pairs);
    const FourBar moved = placed(bars, *there);
    EXPECT_NEAR(std::abs(poses[1].pose.origin - moved.input_moving), 0, 1e-12);
    EXPECT_NEAR(std::abs(displaced(bars.output_moving, poses[0].pose, poses[1].pose) - moved.output_moving), 0, 1e-9);
    const double size = 1 + std::abs(rates->coupler_acceleration);
    EXPECT_NEAR(poses[1].derivatives[0].angle, rates->coupler, 1e-9 * size);
    EXPECT_NEAR(poses[1].derivatives[1].angle, rates->coupler_acceleration, 1e-8 * size);
    EXPECT_NEAR(std::abs(poses[1].derivatives[0].origin - Point{0, 1} * (moved.input_moving - moved.input_fixed)), 0,
                1e-12);
    EXPECT_LT(coupler_residual(bars, pairs), 1e-9);
  }
}

// Type, order, branch and circuit by sign tests and by driving say the same of the coupler's poses.
TEST(FunctionLinkage, DefectsAreConfirmedByDriving) {
  std::mt19937_64 random(3);
  int driven = 0, free = 0;
  for (int i = 0; i < 60; ++i) {
    const bool mixed = i % 3 == 2;
    const auto pairs = mixed ? testing::random_pairs(random, {1, 2, 1}) : testing::gentle_pairs(random, 4);
    const auto bars = linkage_at({{pairs, {}, {}}, {1, 1}, {4, 0}}, uniform(random, 0, 1));
    if (!bars || bars->lengths().longest() > 30 * bars->lengths().shortest()) continue;
    const auto poses = coupler_poses(*bars, pairs);
    const DefectReport report = find_defects(*bars, poses);
    const DriveThroughReport drive = drive_through(*bars, poses, {.respect_direction = true});
    if (!drive.completed) continue;
    ++driven;
    EXPECT_EQ(drive.defects, report.defects) << "task " << i;
    EXPECT_LT(drive.worst_pose_error, 1e-7);
    if (!report.defects.none()) continue;
    ++free;
    const DriveTable table = drive_table(pose_visits(*bars, poses), poses, 50);
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      ASSERT_GE(table.state_of_pose[j], 0);
      const DriveState& state = table.states[static_cast<std::size_t>(table.state_of_pose[j])];
      EXPECT_NEAR(std::remainder(state.output_turn - (pairs[j].output - pairs[0].output), two_pi), 0, 1e-8);
    }
  }
  EXPECT_GT(driven, 25);
  EXPECT_GT(free, 3);
}

}  // namespace
}  // namespace linkwright::function_linkage_test
