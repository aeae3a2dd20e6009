#include "planar/task_curve.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/random_task.hpp"
#include "support/tailgate.hpp"

namespace linkwright::task_curve_test {
namespace {

using testing::motion_task;

double number(const Notice& notice, const std::string& name) {
  for (const NamedValue& value : notice.values)
    if (value.name == name) return std::get<double>(value.value);
  ADD_FAILURE() << "no value " << name;
  return 0;
}

TEST(TaskCurve, OfAnOrdinaryTaskHasNothingToSay) {
  const TaskCurve given = task_curve(testing::tailgate_task());
  EXPECT_EQ(given.pattern, "P-P-P-P");
  EXPECT_EQ(given.curve->kind(), CubicKind::two_branches);
  EXPECT_FALSE(given.degeneracy);
  EXPECT_TRUE(given.warnings.empty());
}

TEST(TaskCurve, NamesTheCommonPole) {
  std::vector<Pose> poses;
  for (const double angle : {0.0, 0.3, 0.8, 1.1})
    poses.push_back({Point{5, -7} + direction(angle) * Point{3, 4}, angle});
  const TaskCurve given = task_curve(motion_task(poses));
  ASSERT_TRUE(given.degeneracy);
  EXPECT_EQ(given.degeneracy->code, "common_pole");
  EXPECT_NEAR(number(*given.degeneracy, "x"), 5, 1e-6);
  EXPECT_NEAR(number(*given.degeneracy, "y"), -7, 1e-6);
}

TEST(TaskCurve, TellsShiftsOnACircleFromOtherShifts) {
  const TaskCurve circle = task_curve(motion_task({{{2, 0}, 0}, {{0, 2}, 0}, {{-2, 0}, 0}, {{0, -2}, 0}}));
  ASSERT_TRUE(circle.degeneracy);
  EXPECT_EQ(circle.degeneracy->code, "translations_on_circle");
  EXPECT_NEAR(number(*circle.degeneracy, "x"), -2, 1e-9);
  const TaskCurve others = task_curve(motion_task({{{2, 0}, 0}, {{0, 2}, 0}, {{-2, 0}, 0}, {{0, -3}, 0}}));
  ASSERT_TRUE(others.degeneracy);
  EXPECT_EQ(others.degeneracy->code, "only_translations");
}

TEST(TaskCurve, WarnsWithTheNumbersOfItsSentences) {
  const TaskCurve parallel = task_curve(motion_task({{{0, 0}, 0}, {{10, 0}, 0.5}, {{10, 10}, 0}, {{0, 12}, 0.7}}));
  ASSERT_EQ(parallel.warnings.size(), 1u);
  EXPECT_EQ(parallel.warnings[0].code, "parallel_poses");
  EXPECT_EQ(std::get<std::string>(parallel.warnings[0].values[0].value), "1 and 3");
}

}  // namespace
}  // namespace linkwright::task_curve_test
