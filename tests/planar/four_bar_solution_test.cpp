#include "linkwright/planar/four_bar_solution.hpp"

#include <gtest/gtest.h>

#include "support/planar_case.hpp"
#include "support/tailgate.hpp"

namespace linkwright::four_bar_solution_test {
namespace {

TEST(MakeFourBar, SlidersAndTheSameDyadTwiceAreNoFourBar) {
  const MotionTask task{testing::planar_case("cardan").poses, {}};
  const TaskFamily given = task_family(task, {}, Objective::min_transmission_angle);
  const double on_circle = 1.3, on_line = 0.3;
  EXPECT_FALSE(make_four_bar(given, {on_circle, on_line}, true, false));
  EXPECT_FALSE(make_four_bar(given, {on_line, on_line}, true, false));
  EXPECT_TRUE(make_four_bar(given, {on_line, 0.6}, true, false));
}

TEST(MakeFourBar, ThereIsNoneWithoutAFamily) { EXPECT_FALSE(make_four_bar({}, {0.2, 0.4}, true, false)); }

TEST(MakeFourBar, IsMeasuredInTheUsersCoordinates) {
  const TaskFamily given = task_family(testing::tailgate_task(), {}, Objective::min_transmission_angle);
  const auto found = make_four_bar(given, {1.3125, 1.1125}, true, true);
  ASSERT_TRUE(found);
  EXPECT_LT(found->residual, 1e-13);
  EXPECT_TRUE(found->verified_by_driving);
  EXPECT_FALSE(found->residual_derivatives);
  EXPECT_FALSE(found->function);
}

}  // namespace
}  // namespace linkwright::four_bar_solution_test
