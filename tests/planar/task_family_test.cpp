#include "linkwright/planar/task_family.hpp"

#include <gtest/gtest.h>
#include <random>

#include "support/planar_case.hpp"
#include "support/random_task.hpp"
#include "support/tailgate.hpp"

namespace linkwright::task_family_test {
namespace {

TaskFamily given_by(const MotionTask& task) { return task_family(task, {}, Objective::min_transmission_angle); }

TEST(TaskFamily, FourPositionsAreACurve) {
  const TaskFamily given = given_by(testing::tailgate_task());
  ASSERT_TRUE(given.family);
  ASSERT_TRUE(given.curve);
  EXPECT_EQ(given.pattern, "P-P-P-P");
  EXPECT_TRUE(given.family->is_symmetric());
  EXPECT_EQ(given.family->axis(Side::input).quantity, AxisQuantity::curve_coordinate);
  EXPECT_TRUE(given.derivative_rows.empty());
}

TEST(TaskFamily, DegenerateTasksSayWhy) {
  const TaskFamily given = given_by({testing::planar_case("pure_translations").poses, {}});
  EXPECT_FALSE(given.family);
  ASSERT_TRUE(given.degeneracy);
  EXPECT_EQ(given.degeneracy->code, "only_translations");
}

// Far apart, yet dependent.
TEST(TaskFamily, DependentConditionsAreNotTakenForPosesThatAreClose) {
  MotionTask task;
  for (const double angle : {0.0, 0.3, 0.7, 1.2, 1.9})
    task.poses.push_back({{Point{3, 4} + direction(angle) * Point{-1, 2}, angle}, {}});
  const TaskFamily pole = given_by(task);
  ASSERT_TRUE(pole.degeneracy);
  EXPECT_EQ(pole.degeneracy->code, "common_pole");
  EXPECT_TRUE(pole.warnings.empty());
  for (PrescribedPose& pose : task.poses) pose = {{direction(2 * pose.pose.angle), 0}, {}};
  const TaskFamily shifts = given_by(task);
  ASSERT_TRUE(shifts.degeneracy);
  EXPECT_EQ(shifts.degeneracy->code, "translations_on_circle");
  EXPECT_TRUE(shifts.warnings.empty());
  std::mt19937_64 random(55);
  task.poses = testing::random_poses(random, 4);
  task.poses.push_back(task.poses[2]);
  const TaskFamily curve = given_by(task);
  EXPECT_TRUE(curve.curve);
  ASSERT_FALSE(curve.warnings.empty());
  EXPECT_EQ(curve.warnings.front().code, "parallel_poses");
  EXPECT_EQ(curve.warnings.back().code, "dependent_rows");
}

TEST(TaskFamily, DefaultsOfRequirementsFollowTheFrame) {
  TaskFamily given;
  given.size = 3;
  EXPECT_EQ(with_defaults({}, given).max_length, 30);
  Requirements wanted;
  wanted.max_length = 7;
  EXPECT_EQ(with_defaults(wanted, given).max_length, 7);
}

}  // namespace
}  // namespace linkwright::task_family_test
