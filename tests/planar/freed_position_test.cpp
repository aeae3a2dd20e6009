#include "linkwright/planar/freed_position.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/random_task.hpp"

namespace linkwright::freed_position_test {
namespace {

using testing::motion_task;

// A classical exercise, without a usable four-bar through all five.
MotionTask sandor_erdman() {
  return motion_task({{{0, 0}, 0},
                      {{1.5, 0.8}, radians(10)},
                      {{1.6, 1.5}, radians(20)},
                      {{2, 3}, radians(60)},
                      {{2.3, 3.5}, radians(90)}});
}

// A trunk lid, which a four-bar leads through all five with 24° at least.
MotionTask hatch() {
  return motion_task({{{0, 0}, 0},
                      {{-20, 95}, radians(-12)},
                      {{-80, 215}, radians(-32)},
                      {{-200, 335}, radians(-60)},
                      {{-330, 410}, radians(-95)}});
}

FreedPositionOptions coarse() {
  FreedPositionOptions options;
  options.region_samples = 60;
  options.starts = 3;
  return options;
}

TEST(FreedPosition, OfATaskThatAFourBarDoesMissesNothing) {
  const std::vector<FreedPosition> found = nearest_relaxations(hatch(), {}, coarse());
  ASSERT_EQ(found.size(), 5u);
  const double size = pose_conditions(hatch().poses).frame.scale;
  for (const FreedPosition& freed : found) {
    ASSERT_TRUE(freed.linkage) << freed.pose;
    EXPECT_LT(freed.combined, 1e-9 * size) << freed.pose;
    EXPECT_TRUE(freed.linkage->report.defects.none());
    EXPECT_TRUE(freed.linkage->verified_by_driving);
    EXPECT_FALSE(freed.reason);
  }
}

TEST(FreedPosition, IsServedAsNearlyAsAUsableFourBarCan) {
  const MotionTask task = sandor_erdman();
  const FreedPositionOptions options = coarse();
  const std::vector<FreedPosition> found = nearest_relaxations(task, {}, options);
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const FreedPosition& freed = found[i];
    ASSERT_TRUE(freed.linkage);
    EXPECT_TRUE(freed.linkage->report.defects.none());
    EXPECT_TRUE(freed.linkage->verified_by_driving);
    EXPECT_LT(freed.linkage->residual, 1e-12);
    EXPECT_GT(freed.combined, 0.05);
    EXPECT_GT(freed.meeting, 0);
    if (i > 0) {
      EXPECT_GE(freed.combined, found[i - 1].combined);
    }
    const FreedTask left = freed_task(task, freed.pose);
    const auto again = pose_miss(freed.linkage->four_bar, left.task.poses, left.freed);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->combined(left.freed.size), freed.combined);
  }
}

TEST(FreedPosition, NoCellOfTheMapComesNearer) {
  const MotionTask task = sandor_erdman();
  Requirements requirements;
  requirements.max_length = default_max_length * pose_conditions(task.poses).frame.scale;
  for (const FreedPosition& freed : nearest_relaxations(task, requirements, coarse())) {
    const FreedTask left = freed_task(task, freed.pose);
    const TaskFamily given = task_family(left.task, requirements, Objective::min_transmission_angle);
    const auto tau = given.family->samples(Side::input, 60, Spacing::coordinate);
    RegionMap map;
    given.family->classify(map, tau, tau, true);
    std::vector<std::uint8_t> failures(map.rows() * map.columns());
    Requirements usable = requirements;
    usable.min_transmission_angle = freed.linkage->report.min_transmission_angle + 1e-6;
    filter_of(*given.family, map, usable).failures_of_all(failures);
    std::vector<float> misses(failures.size());
    pose_misses(*given.family, map, failures, left.freed, misses);
    for (std::size_t cell = 0; cell < misses.size(); ++cell) {
      EXPECT_EQ(misses[cell] < 0, failures[cell] != 0);
      if (misses[cell] >= 0) {
        EXPECT_GE(static_cast<double>(misses[cell]), freed.combined * (1 - 1e-6));
      }
    }
  }
}

TEST(FreedPosition, KeepsToTheRequirements) {
  Requirements requirements;
  requirements.min_transmission_angle = radians(35);
  requirements.max_link_ratio = 4;
  for (const FreedPosition& freed : nearest_relaxations(sandor_erdman(), requirements, coarse())) {
    if (!freed.linkage) {
      ASSERT_TRUE(freed.reason);
      EXPECT_EQ(freed.reason->code, "none_left");
      continue;
    }
    EXPECT_GE(freed.linkage->report.min_transmission_angle, radians(35) - 1e-12);
    EXPECT_LE(freed.linkage->lengths.longest() / freed.linkage->lengths.shortest(), 4 + 1e-12);
  }
}

// However much more a usable linkage is asked for.
TEST(FreedPosition, CountsWhatMeetsTheRequirements) {
  const MotionTask task = sandor_erdman();
  Requirements same_length;
  same_length.max_length = default_max_length * pose_conditions(task.poses).frame.scale;
  SynthesisOptions options;
  options.region_samples = coarse().region_samples;
  options.best = 0;
  for (const FreedPosition& freed : nearest_relaxations(task, {}, coarse())) {
    const auto four = solve(freed_task(task, freed.pose).task, same_length, options);
    ASSERT_TRUE(four.ok());
    EXPECT_EQ(freed.meeting, findings(*four).meeting_requirements) << freed.pose;
    EXPECT_GT(freed.meeting, 0);
  }
}

TEST(FreedPosition, SaysWhyThereIsNothing) {
  std::vector<Pose> poses;
  for (const double angle : {0.0, 0.3, 0.8, 1.1}) poses.push_back({direction(angle) * Point{3, 4}, angle});
  poses.push_back({{1, 1}, 0.5});
  const std::vector<FreedPosition> found = nearest_relaxations(motion_task(poses), {}, coarse());
  ASSERT_EQ(found.size(), 5u);
  const FreedPosition& last = found.back();
  EXPECT_EQ(last.pose, 4u);
  ASSERT_TRUE(last.reason);
  EXPECT_EQ(last.reason->code, "common_pole");
}

TEST(FreedPosition, IsAPoseOfOnePositionOnly) {
  MotionTask task = sandor_erdman();
  task.poses.pop_back();
  task.poses[1].derivatives = {{{1, 0.5}, 0.3}};
  const std::vector<FreedPosition> found = nearest_relaxations(task, {}, coarse());
  ASSERT_EQ(found.size(), 3u);
  for (const FreedPosition& freed : found) EXPECT_NE(freed.pose, 1u);
}

TEST(FreedPosition, StopsWhenCancelled) {
  std::atomic<bool> cancelled = true;
  EXPECT_TRUE(nearest_relaxations(sandor_erdman(), {}, coarse(), {nullptr, &cancelled}).empty());
}

}  // namespace
}  // namespace linkwright::freed_position_test
