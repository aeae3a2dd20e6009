#include "linkwright/mechanism/drive_table.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "mechanism/transmission_angle.hpp"
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
        for (const auto& [from, to] : {std::pair{first.input_moving, state.four_bar.input_moving},
                                       std::pair{first.output_moving, state.four_bar.output_moving}})
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

std::vector<LinkLengths> drawn_lengths(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> length(1, 10);
  std::vector<LinkLengths> drawn;
  while (std::ssize(drawn) < count) {
    const LinkLengths lengths{length(random), length(random), length(random), length(random)};
    if (!input_ranges(lengths).empty()) drawn.push_back(lengths);
  }
  return drawn;
}

/// The most among many even steps, and where.
TransmissionPeak dense_peak(const LinkLengths& lengths, const AngleRange& range) {
  constexpr int steps = 20'000;
  TransmissionPeak peak{-1, 0};
  for (int k = 0; k <= steps; ++k) {
    const double input = range.from + (range.to - range.from) * k / steps;
    const auto there = assemble(lengths, input, Assembly::negative);
    if (!there) continue;
    if (const double angle = transmission_angle(lengths, *there); angle > peak.angle) peak = {angle, input};
  }
  return peak;
}

TEST(DriveExtremes, TheLargestTransmissionAngleIsThatOfAThousandthOfADegree) {
  for (const LinkLengths& lengths : drawn_lengths(60))
    for (const AngleRange& range : input_ranges(lengths)) {
      const TransmissionPeak peak = largest_transmission_angle(lengths, range), dense = dense_peak(lengths, range);
      EXPECT_GE(peak.angle, dense.angle - 1e-12);
      EXPECT_NEAR(peak.angle, dense.angle, 2e-3);
      EXPECT_GE(peak.input_angle, range.from);
      EXPECT_LE(peak.input_angle, range.to);
      const auto there = assemble(lengths, peak.input_angle, Assembly::positive);
      ASSERT_TRUE(there);
      EXPECT_NEAR(transmission_angle(lengths, *there), peak.angle, 1e-12);
    }
}

// In a table a degree apart it was 89.41° at 52.39°.
TEST(DriveExtremes, ARightAngleIsARightAngle) {
  const LinkLengths lengths{8, 6, 4, 5};
  const TransmissionPeak peak = largest_transmission_angle(lengths, input_ranges(lengths).front());
  EXPECT_NEAR(degrees(peak.angle), 90, 1e-6);
  EXPECT_NEAR(std::abs(degrees(wrap_signed(peak.input_angle))), 52.08, 0.005);
}

TEST(DriveExtremes, OfNoLinksIsNothing) {
  EXPECT_EQ(largest_transmission_angle({0, 1, 1, 1}, {0, 1}).angle, 0);
  EXPECT_FALSE(output_rates_full_turn({0, 1, 1, 1}, Assembly::positive));
  EXPECT_FALSE(output_rates_full_turn({8, 6, 4, 5}, Assembly::positive));  // no crank
}

RatioRange dense_rates(const LinkLengths& lengths, Assembly assembly, double from, double to) {
  constexpr int steps = 40'000;
  RatioRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int k = 0; k <= steps; ++k) {
    const auto there = assemble(lengths, from + (to - from) * k / steps, assembly);
    const double rate = angle_rates(lengths, *there)->output;
    range = {std::min(range.least, rate), std::max(range.most, rate)};
  }
  return range;
}

void expect_extremes(const LinkLengths& lengths) {
  for (const Assembly assembly : {Assembly::positive, Assembly::negative}) {
    const auto found = output_rates_full_turn(lengths, assembly);
    ASSERT_TRUE(found);
    RatioRange dense = dense_rates(lengths, assembly, -pi, pi);
    for (const double line : {0.0, pi})  // where a linkage near its change point is quick
      for (const double width : {1e-1, 1e-3, 1e-5}) {
        const RatioRange near = dense_rates(lengths, assembly, line - width, line + width);
        dense = {std::min(dense.least, near.least), std::max(dense.most, near.most)};
      }
    const double size = dense.most - dense.least;
    EXPECT_LE(found->least, dense.least + 1e-9 * size);
    EXPECT_GE(found->most, dense.most - 1e-9 * size);
    EXPECT_NEAR(found->least, dense.least, 1e-5 * size);
    EXPECT_NEAR(found->most, dense.most, 1e-5 * size);
  }
}

TEST(DriveExtremes, VelocityRatiosOfACrankAreThoseOfManySteps) {
  int cranks = 0;
  for (const LinkLengths& lengths : drawn_lengths(40)) {
    if (!input_is_crank(linkage_type(lengths))) continue;
    ++cranks;
    expect_extremes(lengths);
  }
  EXPECT_GT(cranks, 3);
}

TEST(DriveExtremes, NearAChangePointTheyLieWithinADegree) {
  for (const double off : {1e-2, 1e-4, 1e-6}) expect_extremes({10, 2, 7, 5 + off});
}

}  // namespace
}  // namespace linkwright::drive_table_test
