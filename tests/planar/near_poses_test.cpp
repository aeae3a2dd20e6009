#include "linkwright/planar/near_poses.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "planar/fitted_motion_family.hpp"
#include "support/curve_case.hpp"

namespace linkwright::near_poses_test {
namespace {

// Those that are not exact are near.
MotionTask task_of(const PoseTarget& target) {
  MotionTask task;
  for (std::size_t j = 0; j < target.poses.size(); ++j) {
    if (target.is_exact(j))
      task.poses.push_back({target.poses[j], {}});
    else
      task.near.push_back({target.poses[j], task.poses.size(), {}, {}});
  }
  task.turning_length = target.turning_length;
  return task;
}

MotionTask tailgate() { return task_of(testing::pose_case("poses_tailgate8")); }

MotionTask all_near() {
  PoseTarget target = testing::pose_case("poses_tailgate8");
  target.exact.clear();
  return task_of(target);
}

std::string codes(const MotionTask& task) {
  std::string text;
  for (const Error& e : mistakes_in(task)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place;
  return text;
}

TEST(NearPoses, StandAmongExactOnesInTheOrderOfTheTask) {
  const MotionTask task = tailgate();
  const std::vector<TaskPlace> places = places_of(task);
  std::string order;
  for (const TaskPlace& place : places) order += place.is_near ? 'n' : 'e';
  EXPECT_EQ(order, "enenenne");
  const PoseTarget target = testing::pose_case("poses_tailgate8");
  const auto all = all_poses(task);
  ASSERT_EQ(all.size(), target.poses.size());
  for (std::size_t j = 0; j < all.size(); ++j) EXPECT_EQ(all[j].pose, target.poses[j]);
  EXPECT_EQ(NearPoses(task).target().exact, target.exact);
}

TEST(NearPoses, FewerThanFourExactOnesAreFittedUnlessMoreIsGiven) {
  MotionTask task = tailgate();
  EXPECT_FALSE(task.is_fitted());
  EXPECT_EQ(&task.linkage_class(), &near_motion_linkages);
  task.poses.pop_back();
  EXPECT_TRUE(task.is_fitted());
  task.given = SideLengths{30, 40};
  EXPECT_FALSE(task.is_fitted());
  task.near.clear();
  EXPECT_FALSE(task.is_fitted());
  EXPECT_EQ(&task.linkage_class(), &planar_linkages);
}

TEST(NearPoses, TellWhatDoesNotGoWithThem) {
  EXPECT_EQ(codes(tailgate()), "");
  EXPECT_EQ(codes(all_near()), "");
  MotionTask task = tailgate();
  task.near[1].tolerance = NearPose::Tolerance{0.0, {}};
  EXPECT_EQ(codes(task), "near_tolerance@task.poses[3].tolerance.position");
  task.near[1].tolerance = NearPose::Tolerance{{}, -0.1};
  EXPECT_EQ(codes(task), "near_angle_tolerance@task.poses[3].tolerance.angle_deg");
  task.near[1].tolerance = NearPose::Tolerance{};
  EXPECT_EQ(codes(task), "near_tolerance_empty@task.poses[3].tolerance");
  task = tailgate();
  task.near[2].weight = -1;
  EXPECT_EQ(codes(task), "near_weight@task.poses[5].weight");
  task = tailgate();
  for (NearPose& near : task.near) near.weight = 0;
  EXPECT_EQ(codes(task), "no_near_weight@task.poses");
  task = tailgate();
  task.turning_length = 0;
  EXPECT_EQ(codes(task), "near_turning_length@task.turning_length");
  task = tailgate();
  task.near.clear();
  EXPECT_EQ(codes(task), "unneeded_turning_length@task.turning_length");
  task = tailgate();
  task.poses.push_back({{{-240, 470}, -1.5}, {}});
  task.relaxed = 0;
  EXPECT_EQ(codes(task), "near_with_freed_pose@task.freed_pose");
  task = all_near();
  task.near.resize(2);
  EXPECT_EQ(codes(task), "too_few_near_poses@task.poses");
  task = all_near();
  task.poses.push_back({task.near[0].pose, {{{1, 0}, 0}}});
  task.poses[0].pose.origin += Point{5, 5};
  EXPECT_EQ(codes(task), "near_with_derivatives@task.poses[8].derivatives");
  task = all_near();
  task.near.resize(MotionTask::most_near + 1, task.near[3]);
  EXPECT_EQ(codes(task), "too_many_near_poses@task.poses");
  task = all_near();
  task.near[4].pose.angle = std::nan("");
  EXPECT_NE(codes(task).find("task.poses[4].theta_deg"), std::string::npos);
}

// Directions of travel count as positions, so that of four exact ones and a near one only two poses may be distinct.
TEST(NearPoses, AreComparedWithWhereTwoPosesAreDistinct) {
  MotionTask task;
  task.poses = {{{{0, 0}, 0}, {{{1, 0.3}, 0.5}}}, {{{3, 1}, 0.5}, {{{1, -0.3}, 0.4}}}};
  task.near.push_back({{{0, 0}, 0}, 2, {}, {}});
  ASSERT_EQ(codes(task), "");
  const FourBar bars = {{0, 2}, {1, 0.5}, {4, 2}, {3, 0.5}};
  const auto miss = NearPoses(task).miss_of(bars, task.poses.front().pose);
  ASSERT_TRUE(miss);
  EXPECT_EQ(miss->at.size(), 3u);
  EXPECT_TRUE(std::isfinite(miss->error.rms) && std::isfinite(miss->error.exact_residual));
}

// What a map holds of its cells is what comparing each linkage by itself finds, wherever that takes all in turn.
TEST(NearPoses, ErrorOfCellsIsThatOfTheLinkageDrivenThroughAllPoses) {
  const MotionTask task = tailgate();
  const TaskFamily given = task_family(task, {}, Objective::near_error);
  ASSERT_TRUE(given.family && given.near && given.near_error);
  const auto samples = given.family->samples(Side::input, 40, Spacing::coordinate);
  int compared = 0, unlike = 0;
  for (const double input : samples)
    for (const double output : samples) {
      const auto error = given.near_error->at({input, output});
      const auto pair = given.family->dyad_pair({input, output});
      const auto working = pair ? four_bar_of(*pair) : std::nullopt;
      if (!error || !std::isfinite(*error) || !working || input == output) continue;
      const FourBar bars = given.frame().to_user(*working);
      const auto miss = given.near->miss_of(bars, task.poses.front().pose);
      if (!miss || !miss->in_order) continue;
      ++compared;
      if (std::abs(miss->error.rms - *error) > 1e-6 * (1 + *error)) ++unlike;
      EXPECT_LT(miss->error.exact_residual, 1e-6 * given.size);
    }
  EXPECT_GT(compared, 50);
  EXPECT_EQ(unlike, 0);
}

TEST(NearPoses, FitsAreListedWithTheirErrors) {
  const MotionTask task = all_near();
  const TaskFamily given = family_of_near(task, with_default_lengths({}, 100), {}, {});
  ASSERT_TRUE(given.family);
  const auto error = given.near_error->at({0.5, 0.5});
  ASSERT_TRUE(error);
  EXPECT_LE(*error, 1.0573);
  const auto next = given.near_error->at({1.5, 0.5});
  if (next) {
    EXPECT_LE(*error, *next);
  }
  EXPECT_FALSE(given.near_error->at({1e6, 0.5}));
}

}  // namespace
}  // namespace linkwright::near_poses_test
