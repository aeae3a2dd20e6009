#include "linkwright/analysis/drive_table.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/random_four_bar.hpp"
#include "support/tailgate.hpp"

namespace linkwright::drive_table_test {
namespace {

using testing::tailgate_task;

constexpr int samples = 361;

struct Driven {
  FourBarSolution found;
  DriveTable table;
};

std::optional<Driven> driven(const MotionTask& task, const TaskFamily& given, double input, double output) {
  const auto found = make_four_bar(given, {input, output}, true, false);
  if (!found) return std::nullopt;
  return Driven{*found, drive_table(pose_visits(found->four_bar, task.poses), task.poses, samples)};
}

// Acceptance walk-through 14.
TEST(DriveTable, PutsTheBodyExactlyWhereItIsPrescribed) {
  const MotionTask task = tailgate_task();
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  const Driven drive = *driven(task, given, 1.3125, 1.1125);
  int last = -1;
  for (std::size_t pose = 0; pose < 4; ++pose) {
    const int state = drive.table.state_of_pose[pose];
    ASSERT_GT(state, last) << "in order";
    last = state;
    const DriveState& here = drive.table.states[static_cast<std::size_t>(state)];
    EXPECT_EQ(here.body.origin, task.poses[pose].pose.origin);
    EXPECT_NEAR(here.body.angle, task.poses[pose].pose.angle, 1e-14);
  }
  EXPECT_EQ(drive.table.states[static_cast<std::size_t>(drive.table.state_of_pose[0])].turn, 0);
  EXPECT_NEAR(drive.table.states[static_cast<std::size_t>(last)].turn, drive.found.report.sweep, 1e-9);
}

TEST(DriveTable, CarriesTheBodyAlong) {
  const MotionTask task = tailgate_task();
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  const auto coordinates = given.curve->samples(24, Spacing::coordinate);
  for (const double input : coordinates)
    for (const double output : coordinates) {
      if (input == output) continue;
      const auto drive = driven(task, given, input, output);
      if (!drive) continue;
      const FourBar& first = drive->found.four_bar;
      const LinkLengths lengths = drive->found.lengths;
      const double size = lengths.perimeter();
      ASSERT_GE(drive->table.states.size(), samples - 4u);
      const DriveState* before = nullptr;
      for (const DriveState& state : drive->table.states) {
        const LinkLengths here = state.four_bar.lengths();
        ASSERT_NEAR(here.input, lengths.input, 1e-11 * size);
        ASSERT_NEAR(here.output, lengths.output, 1e-11 * size);
        // The body carries both moving pivots.
        for (const auto& [from, to] : {std::pair{first.input_circle, state.four_bar.input_circle},
                                       std::pair{first.output_circle, state.four_bar.output_circle}})
          ASSERT_LT(std::abs(displaced(from, task.poses[0].pose, state.body) - to), 1e-6 * size);
        if (before) {
          ASSERT_GT(state.turn, before->turn);
          ASSERT_LT(std::abs(state.body.angle - before->body.angle), 1.0) << "no jumps";
        }
        before = &state;
      }
    }
}

TEST(DriveTable, MarksPosesThatTheDriveDoesNotReach) {
  const MotionTask task = tailgate_task();
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  int apart = 0;
  for (const double input : given.curve->samples(24, Spacing::coordinate)) {
    const auto drive = driven(task, given, input, 1.1125);
    if (!drive) continue;
    const auto& states = drive->table.state_of_pose;
    const bool all = std::count(states.begin(), states.end(), -1) == 0;
    EXPECT_EQ(all, !drive->found.report.defects.branch()) << input;
    apart += !all;
  }
  EXPECT_GT(apart, 0);
}

TEST(DriveTable, ARockersEndsAreDeadPoints) {
  const MotionTask task = tailgate_task();
  const Driven drive = *driven(task, task_family(task, {}, Objective::min_transmission_angle), 1.3125, 1.1125);
  EXPECT_FALSE(drive.table.full_turn);
  for (const DriveState* end : {&drive.table.states.front(), &drive.table.states.back()}) {
    EXPECT_LT(end->transmission_angle, 1e-6);
    EXPECT_EQ(end->velocity_ratio, 0);
    EXPECT_EQ(end->mechanical_advantage, 0);
  }
}

TEST(DriveTable, VelocityRatioIsTheSlopeOfTheOutput) {
  const MotionTask task = tailgate_task();
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  const auto found = driven(task, given, 1.3125, 1.1125);
  const PoseVisits visits = pose_visits(found->found.four_bar, task.poses);
  const DriveTable fine = drive_table(visits, task.poses, 20'001);
  const double sense = visits.counter_clockwise ? 1 : -1;
  for (std::size_t i = 2000; i + 2000 < fine.states.size(); i += 997) {
    const DriveState &a = fine.states[i - 1], &b = fine.states[i + 1];
    const double slope = sense * (b.output_turn - a.output_turn) / (b.turn - a.turn);
    EXPECT_NEAR(fine.states[i].velocity_ratio, slope, 1e-4 * std::abs(slope) + 1e-6);
    EXPECT_NEAR(fine.states[i].mechanical_advantage * std::abs(fine.states[i].velocity_ratio), 1, 1e-12);
  }
}

TEST(DriveTable, IsEmptyWithoutALinkage) {
  const std::vector<PrescribedPose> poses(4);
  EXPECT_TRUE(drive_table(pose_visits(FourBar{}, poses), poses, samples).states.empty());
}

}  // namespace
}  // namespace linkwright::drive_table_test
