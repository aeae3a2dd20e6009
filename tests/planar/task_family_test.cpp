#include "linkwright/planar/task_family.hpp"

#include <gtest/gtest.h>

#include "support/planar_case.hpp"
#include "support/tailgate.hpp"

namespace linkwright {
namespace {

TaskFamily given_by(const MotionTask& task) { return task_family(task, {}, Objective::min_transmission_angle); }

TEST(TaskFamily, FourPositionsAreACurve) {
  const TaskFamily given = given_by(testing::tailgate_task());
  ASSERT_TRUE(given.family);
  ASSERT_TRUE(given.curve);
  EXPECT_EQ(given.pattern, "P-P-P-P");
  EXPECT_TRUE(given.family->is_symmetric());
  EXPECT_EQ(given.family->axis(LinkageFamily::Side::input).quantity, AxisQuantity::curve_coordinate);
  EXPECT_TRUE(given.derivative_rows.empty());
}

TEST(TaskFamily, DegenerateTasksSayWhy) {
  const TaskFamily given = given_by({testing::planar_case("pure_translations").poses, {}});
  EXPECT_FALSE(given.family);
  ASSERT_TRUE(given.degeneracy);
  EXPECT_EQ(given.degeneracy->code, "only_translations");
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
}  // namespace linkwright
