#include "linkwright/planar/relaxed_position.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/random_task.hpp"

namespace linkwright::relaxed_position_test {
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

RelaxedPositionOptions coarse() {
  RelaxedPositionOptions options;
  options.region_samples = 60;
  options.starts = 3;
  return options;
}

TEST(RelaxedPosition, OfATaskThatAFourBarDoesMissesNothing) {
  const std::vector<RelaxedPosition> found = drop_one_position(hatch(), {}, coarse());
  ASSERT_EQ(found.size(), 5u);
  const double size = pose_conditions(hatch().poses).frame.scale;
  for (const RelaxedPosition& relaxed : found) {
    ASSERT_TRUE(relaxed.linkage) << relaxed.pose;
    EXPECT_LT(relaxed.combined, 1e-9 * size) << relaxed.pose;
    EXPECT_TRUE(relaxed.linkage->report.defects.none());
    EXPECT_TRUE(relaxed.linkage->verified_by_driving);
    EXPECT_FALSE(relaxed.reason);
  }
}

TEST(RelaxedPosition, IsServedAsNearlyAsAUsableFourBarCan) {
  const MotionTask task = sandor_erdman();
  const RelaxedPositionOptions options = coarse();
  const std::vector<RelaxedPosition> found = drop_one_position(task, {}, options);
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const RelaxedPosition& relaxed = found[i];
    ASSERT_TRUE(relaxed.linkage);
    EXPECT_TRUE(relaxed.linkage->report.defects.none());
    EXPECT_TRUE(relaxed.linkage->verified_by_driving);
    EXPECT_LT(relaxed.linkage->residual, 1e-12);
    EXPECT_GT(relaxed.combined, 0.05);
    EXPECT_GT(relaxed.meeting, 0);
    if (i > 0) {
      EXPECT_GE(relaxed.combined, found[i - 1].combined);
    }
    const RelaxedTask left = relaxed_task(task, relaxed.pose);
    const auto again = pose_error(relaxed.linkage->four_bar, left.task.poses, left.relaxed);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->combined(left.relaxed.size), relaxed.combined);
  }
}

TEST(RelaxedPosition, NoCellOfTheMapComesNearer) {
  const MotionTask task = sandor_erdman();
  Requirements requirements;
  requirements.max_length = default_max_length * pose_conditions(task.poses).frame.scale;
  for (const RelaxedPosition& relaxed : drop_one_position(task, requirements, coarse())) {
    const RelaxedTask left = relaxed_task(task, relaxed.pose);
    const TaskFamily given = task_family(left.task, requirements, Objective::min_transmission_angle);
    const auto tau = given.family->samples(Side::input, 60, Spacing::coordinate);
    RegionMap map;
    given.family->classify(map, tau, tau, true);
    std::vector<FailureBits> failures(map.rows() * map.columns());
    Requirements usable = requirements;
    usable.min_transmission_angle = relaxed.linkage->report.min_transmission_angle + 1e-6;
    filter_of(*given.family, map, usable).failures_of_all(failures);
    std::vector<float> errors(failures.size());
    pose_errors(*given.family, map, failures, left.relaxed, errors);
    for (std::size_t cell = 0; cell < errors.size(); ++cell) {
      EXPECT_EQ(errors[cell] < 0, failures[cell] != 0);
      if (errors[cell] >= 0) {
        EXPECT_GE(static_cast<double>(errors[cell]), relaxed.combined * (1 - 1e-6));
      }
    }
  }
}

TEST(RelaxedPosition, KeepsToTheRequirements) {
  Requirements requirements;
  requirements.min_transmission_angle = radians(35);
  requirements.max_link_ratio = 4;
  for (const RelaxedPosition& relaxed : drop_one_position(sandor_erdman(), requirements, coarse())) {
    if (!relaxed.linkage) {
      ASSERT_TRUE(relaxed.reason);
      EXPECT_EQ(relaxed.reason->code, "none_left");
      continue;
    }
    EXPECT_GE(relaxed.linkage->report.min_transmission_angle, radians(35) - 1e-12);
    EXPECT_LE(relaxed.linkage->lengths.longest() / relaxed.linkage->lengths.shortest(), 4 + 1e-12);
  }
}

// However much more a usable linkage is asked for.
TEST(RelaxedPosition, CountsWhatMeetsTheRequirements) {
  const MotionTask task = sandor_erdman();
  Requirements same_length;
  same_length.max_length = default_max_length * pose_conditions(task.poses).frame.scale;
  SynthesisOptions options;
  options.region_samples = coarse().region_samples;
  options.best = 0;
  for (const RelaxedPosition& relaxed : drop_one_position(task, {}, coarse())) {
    const auto four = solve({relaxed_task(task, relaxed.pose).task, same_length, options});
    ASSERT_TRUE(four.ok());
    EXPECT_EQ(relaxed.meeting, findings(*four).meeting_requirements) << relaxed.pose;
    EXPECT_GT(relaxed.meeting, 0);
  }
}

TEST(RelaxedPosition, SaysWhyThereIsNothing) {
  std::vector<Pose> poses;
  for (const double angle : {0.0, 0.3, 0.8, 1.1}) poses.push_back({direction(angle) * Point{3, 4}, angle});
  poses.push_back({{1, 1}, 0.5});
  const std::vector<RelaxedPosition> found = drop_one_position(motion_task(poses), {}, coarse());
  ASSERT_EQ(found.size(), 5u);
  const RelaxedPosition& last = found.back();
  EXPECT_EQ(last.pose, 4u);
  ASSERT_TRUE(last.reason);
  EXPECT_EQ(last.reason->code, "common_pole");
}

TEST(RelaxedPosition, IsAPoseOfOnePositionOnly) {
  MotionTask task = sandor_erdman();
  task.poses.pop_back();
  task.poses[1].derivatives = {{{1, 0.5}, 0.3}};
  const std::vector<RelaxedPosition> found = drop_one_position(task, {}, coarse());
  ASSERT_EQ(found.size(), 3u);
  for (const RelaxedPosition& relaxed : found) EXPECT_NE(relaxed.pose, 1u);
}

TEST(RelaxedPosition, StopsWhenCancelled) {
  std::atomic<bool> cancelled = true;
  EXPECT_TRUE(drop_one_position(sandor_erdman(), {}, coarse(), {nullptr, &cancelled}).empty());
}

}  // namespace
}  // namespace linkwright::relaxed_position_test
