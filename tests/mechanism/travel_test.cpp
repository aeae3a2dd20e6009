#include "linkwright/mechanism/travel.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/chain_family.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "support/file_support.hpp"
#include "support/tailgate.hpp"

namespace linkwright::travel_test {
namespace {

using testing::tailgate_task;

Travel tailgate_travel() {
  const MotionTask task = tailgate_task();
  const auto found =
      make_four_bar(task_family(task, {}, Objective::min_transmission_angle), {1.3125, 1.1125}, true, false);
  return travel_of(pose_visits(found->four_bar, task.poses), task.poses);
}

TEST(Travel, OfAFourBarHasTheStatesOfItsDriveTable) {
  const MotionTask task = tailgate_task();
  const Travel travel = tailgate_travel();
  ASSERT_GE(travel.states.size(), 361u);
  EXPECT_TRUE(travel.reaches_all_positions());
  EXPECT_TRUE(travel.starts_dead && travel.ends_dead);
  ASSERT_EQ(travel.dead_points.size(), 2u);
  EXPECT_NEAR(travel.dead_points[0], travel.states.front().turn, 1e-9);
  EXPECT_NEAR(travel.dead_points[1], travel.states.back().turn, 1e-9);
  for (std::size_t pose = 0; pose < task.poses.size(); ++pose)
    EXPECT_EQ(travel.states[static_cast<std::size_t>(travel.state_of_position[pose])].body.origin,
              task.poses[pose].pose.origin);
}

TEST(Travel, LeadsAPointAlongWithItsBody) {
  const MotionTask task = tailgate_task();
  const Travel travel = tailgate_travel();
  const Point traced = task.poses[0].pose.origin + Point{3, 4};
  const std::vector<Point> path = path_of(travel, traced);
  ASSERT_EQ(path.size(), travel.states.size());
  for (std::size_t pose = 0; pose < task.poses.size(); ++pose)
    EXPECT_LT(std::abs(path[static_cast<std::size_t>(travel.state_of_position[pose])] -
                       displaced(traced, task.poses[0].pose, task.poses[pose].pose)),
              1e-9);
}

// The rates are those of the states: by differences of their angles and of the point's places.
TEST(Travel, HasTheRatesOfItsStates) {
  const Travel travel = tailgate_travel();
  constexpr int coupler = 2;
  const auto rates = rates_of(travel, coupler);
  ASSERT_EQ(rates.size(), travel.states.size());
  int compared = 0;
  for (std::size_t row = 20; row + 20 < rates.size(); row += 10) {
    const TravelState &before = travel.states[row - 1], &after = travel.states[row + 1];
    const double step = after.turn - before.turn;
    if (!rates[row]) continue;
    const std::vector<double>& now = *rates[row];
    ASSERT_EQ(now.size(), 10u);
    EXPECT_NEAR(std::abs(now[0]), 1, 1e-9) << "the driver";
    EXPECT_NEAR(now[2], (after.coupler_turn - before.coupler_turn) / step, 0.02 * (1 + std::abs(now[2])));
    EXPECT_NEAR(now[4], (after.output_turn - before.output_turn) / step, 0.02 * (1 + std::abs(now[4])));
    EXPECT_NEAR(now[6], (after.body.origin - before.body.origin).real() / step, 0.02 * (100 + std::abs(now[6])));
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

SixBar some_six_bar(const SixBarTask& task) {
  const auto family = ChainFamily::of(task);
  for (const double first : family->samples(Side::input, 20, Spacing::coordinate))
    for (const double second : family->samples(Side::output, 20, Spacing::coordinate))
      if (const auto member = family->member({first, second})) return member->six_bar;
  return {};
}

TEST(Travel, OfASixBarIsThatOfItsMotion) {
  const auto task = std::get<SixBarTask>(testing::example("loader_bucket_chain.json", 80).task);
  const SixBar six_bar = some_six_bar(task);
  const std::vector<PrescribedPose>& poses = task.poses;
  const SixBarMotion motion = six_bar_motion(six_bar, poses, pi / 180);
  const Travel travel = travel_of(six_bar, poses, motion);
  EXPECT_EQ(travel.states.size(), motion.states.size());
  EXPECT_EQ(travel.linkage.hinges.size(), SixBar::joint_count);
  const SixBarCheck check = check_by_driving(six_bar, poses, 1);
  const Travel driven = travel_of(six_bar, poses, check, 1);
  EXPECT_EQ(driven.states.size(), check.states.size());
  EXPECT_EQ(driven.state_of_position.front(), 0);
}

}  // namespace
}  // namespace linkwright::travel_test
