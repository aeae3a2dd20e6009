#include "linkwright/files/task_label.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/file_support.hpp"

namespace linkwright::task_label_test {
namespace {

using testing::motion;

MotionTask three(const ThreePoseGiven& given) {
  Problem problem = testing::problem_of({{0, 0, 0}, {1, 1, 30}, {2, 1, 60}});
  motion(problem).given = given;
  return motion(problem);
}

TEST(TaskLabel, SaysWhatThreePositionsAreGiven) {
  EXPECT_EQ(task_label(three(SideLengths{80, 60})), "three positions (P-P-P), grounded links 80 and 60");
  EXPECT_EQ(task_label(three(SideLengths{0.5, {}})), "three positions (P-P-P), input link 0.5");
  EXPECT_EQ(task_label(three(SideAngle{radians(60), true, {}})), "three positions (P-P-P), grounded links at 60°");
  EXPECT_EQ(task_label(three(SideAngle{radians(60), false, 7.5})),
            "three positions (P-P-P), lines of the grounded links at 60°, input 7.5");
  EXPECT_EQ(task_label(three(InstantCenter{{3, -4}})), "three positions (P-P-P), instant centre (3, -4)");
  EXPECT_EQ(task_label(three(InstantCenter{{1, 0}, true})),
            "three positions (P-P-P), instant centre at infinity in direction (1, 0)");
  const GivenPivot ground{PivotKind::ground, {3, -4}}, moving{PivotKind::moving, {0.5, 1}};
  EXPECT_EQ(task_label(three(GivenPivots{ground, GivenPivot{PivotKind::ground, {0, 0}}})),
            "three positions (P-P-P), ground pivots (3, -4) and (0, 0)");
  EXPECT_EQ(
      task_label(three(GivenPivots{ground, moving})),
      "three positions (P-P-P), ground pivot of the input link (3, -4), moving pivot of the output link (0.5, 1)");
  EXPECT_EQ(task_label(three(PivotLines{LineAtAngle({0, 340}, 0), {}})),
            "three positions (P-P-P), ground pivots on the line through (0, 340) at 0°");
}

TEST(TaskLabel, CountsPositionsNotPoses) {
  EXPECT_EQ(task_label(testing::tailgate().task), "four positions (P-P-P-P)");
  EXPECT_EQ(task_label(testing::hood_hinge().task), "four positions (PP-P-P)");
  Problem five = testing::five_without_answer().problem;
  EXPECT_EQ(task_label(five.task), "five positions (P-P-P-P-P)");
  motion(five).relaxed = 2;
  EXPECT_EQ(task_label(five.task), "five positions (P-P-P-P-P), position 3 relaxed");
  EXPECT_EQ(short_task_label(five.task), "five positions");
}

TEST(TaskLabel, NamesTheFunction) {
  EXPECT_EQ(task_label(testing::function().problem.task), "function sin_deg on 4 precision points");
  FunctionTask task;
  task.pairs = {{0, 0, {{1, 0.5}}}, {0.5, 0.2, {}}, {1, 1, {}}};
  EXPECT_EQ(task_label(task), "function on 4 precision points (PP-P-P)");
  task.free = FreeParameter{FreeParameter::Kind::pair_output, {0, 1}, 2};
  EXPECT_EQ(task_label(task), "function on 4 precision points (PP-P-P), the output of pair 3 free");
  task.free = FreeParameter{};
  task.function = NamedFunction{};
  task.function->table = {{{0, 0}, {1, 1}, {2, 4}}};
  EXPECT_EQ(task_label(task), "function of a table with 3 rows on 4 precision points (PP-P-P), the output scale free");
  EXPECT_EQ(short_task_label(task), "function on 4 precision points");
}

TEST(TaskLabel, StartsASentence) {
  EXPECT_EQ(sentence_case("three positions"), "Three positions");
  EXPECT_EQ(sentence_case(""), "");
}

}  // namespace
}  // namespace linkwright::task_label_test
