#include "linkwright/planar/motion_task.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "support/random_task.hpp"

namespace linkwright::motion_task_test {
namespace {

using testing::motion_task;

const std::vector<Pose> good = {{{0, 0}, 0}, {{1, 0}, 0.4}, {{2, 1}, 0.9}, {{2, 3}, 1.7}};

std::string only_code(const MotionTask& t) {
  const auto found = mistakes_in(t);
  return found.size() == 1 ? found[0].code : "not one mistake";
}

TEST(MotionTask, FourDifferentPosesAreFine) { EXPECT_TRUE(mistakes_in(motion_task(good)).empty()); }

TEST(MotionTask, CountIsNamed) {
  EXPECT_EQ(only_code(motion_task({good[0], good[1], good[2]})), "missing_given");
  EXPECT_EQ(only_code(motion_task({good[0], good[1]})), "too_few_poses");
  EXPECT_EQ(only_code(motion_task({good[0], good[1], good[2], good[3], {{9, 9}, 0}, {{9, 8}, 0}})), "too_many_poses");
}

TEST(MotionTask, RepetitionsAreFoundModuloWholeTurns) {
  EXPECT_EQ(only_code(motion_task({good[0], good[1], good[2], good[1]})), "repeated_pose");
  EXPECT_EQ(only_code(motion_task({good[0], good[1], good[2], {good[0].origin, two_pi}})), "repeated_pose");
  const auto found = mistakes_in(motion_task({good[0], good[1], good[1], good[1]}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place, "task.poses[2]");
  EXPECT_EQ(found[1].place, "task.poses[3]");
}

TEST(MotionTask, ClosePosesAreNotRepetitions) {
  EXPECT_TRUE(mistakes_in(motion_task({good[0], {{1e-6, 0}, 1e-6}, good[2], good[3]})).empty());
}

TEST(MotionTask, NumbersMustBeFiniteAndReasonable) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 2e9}) {
    MotionTask t = motion_task(good);
    t.poses[2].pose.origin = {0, bad};
    const auto found = mistakes_in(t);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].place, "task.poses[2].y");
    t = motion_task(good);
    t.poses[3].pose.angle = bad;
    ASSERT_EQ(mistakes_in(t).size(), 1u);
    EXPECT_EQ(mistakes_in(t)[0].place, "task.poses[3].theta_deg");
  }
}

// The first poses of `good`, with as many derivatives as the multiplicities say.
MotionTask mixed(const std::vector<int>& multiplicities) {
  MotionTask result;
  for (const int multiplicity : multiplicities) {
    result.poses.push_back({good[result.poses.size()], {}});
    for (int m = 1; m < multiplicity; ++m) result.poses.back().derivatives.push_back({{1, 0.5 * m}, 0.2});
  }
  return result;
}

TEST(MotionTask, AllPatternsOfFourPositionsAreFine) {
  for (const auto& multiplicities : testing::mixed_patterns()) EXPECT_TRUE(mistakes_in(mixed(multiplicities)).empty());
}

TEST(MotionTask, DerivativesCountAsPositions) {
  EXPECT_EQ(only_code(mixed({1, 1})), "too_few_poses");
  EXPECT_EQ(only_code(mixed({2})), "too_few_positions");
  for (const auto& multiplicities : {std::vector{1, 2, 1, 1}, {2, 2, 1}, {5}, {3, 2}}) {
    EXPECT_TRUE(mistakes_in(mixed(multiplicities)).empty());
  }
  for (const auto& multiplicities : {std::vector{1, 2, 1, 2}, {2, 2, 2}, {6}}) {
    EXPECT_EQ(only_code(mixed(multiplicities)), "too_many_positions");
  }
  EXPECT_EQ(
      mistakes_in(mixed({2, 2, 2}))[0].message,
      "6 positions were given (PP-PP-PP: 3 poses and 3 derivatives, each counting as one) and 5 are the most that "
      "a four-bar can pass exactly; remove 1, or mark some poses \"near\": true");
  EXPECT_EQ(mistakes_in(mixed({100}))[0].message,
            "100 positions were given (PPPPPPPPPPPP…: 1 pose and 99 derivatives, each counting as one) and 5 are the "
            "most that a "
            "four-bar can pass exactly; remove 95, or mark some poses \"near\": true");
}

TEST(MotionTask, ThreePositionsWantSomethingGivenAndOnlyThey) {
  MotionTask three = motion_task({good[0], good[1], good[2]});
  EXPECT_EQ(only_code(three), "missing_given");
  three.given = SideLengths{2, 3};
  EXPECT_TRUE(mistakes_in(three).empty());
  three.given = SideLengths{-2, 3};
  EXPECT_EQ(only_code(three), "side_length_range");
  MotionTask four = motion_task(good);
  four.given = SideLengths{2, 3};
  EXPECT_EQ(only_code(four), "unneeded_given");
  MotionTask directed = mixed({2, 1});
  EXPECT_EQ(only_code(directed), "missing_given");
  directed.given = SideLengths{2, 3};
  EXPECT_TRUE(mistakes_in(directed).empty());
  directed.given = InstantCenter{{1, 2}};
  EXPECT_EQ(only_code(directed), "unneeded_center");
}

TEST(MotionTask, ADirectionIsNotZero) {
  MotionTask t = mixed({1, 3});
  t.poses[1].derivatives[0] = {{0, 0.5 * tolerance::smallest_direction}, -0.5 * tolerance::smallest_direction};
  const auto found = mistakes_in(t);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "zero_derivative");
  EXPECT_EQ(found[0].place, "task.poses[1].derivatives[0]");
  for (const PoseDerivative& enough :
       {PoseDerivative{{tolerance::smallest_direction, 0}, 0}, {{0, -1e-8}, 0}, {{0, 0}, 1e-8}}) {
    t.poses[1].derivatives[0] = enough;
    EXPECT_TRUE(mistakes_in(t).empty());
  }
  t.poses[1].derivatives[1] = {};
  EXPECT_TRUE(mistakes_in(t).empty()) << "no curvature is a curvature";
}

TEST(MotionTask, NumbersOfDerivativesMustBeFiniteAndReasonable) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 2e9}) {
    MotionTask t = mixed({1, 3});
    t.poses[1].derivatives[1] = {{bad, 0}, 0};
    EXPECT_EQ(only_code(t), "number_range");
    EXPECT_EQ(mistakes_in(t)[0].place, "task.poses[1].derivatives[1].x");
    t.poses[1].derivatives[1] = {{0, bad}, 0};
    EXPECT_EQ(mistakes_in(t)[0].place, "task.poses[1].derivatives[1].y");
    t.poses[1].derivatives[1] = {{0, 0}, bad};
    EXPECT_EQ(mistakes_in(t)[0].place, "task.poses[1].derivatives[1].theta");
  }
}

TEST(MotionTask, ADirectionDoesNotMakeAPoseAnother) {
  MotionTask t = mixed({2, 1, 1});
  t.poses[2].pose = good[0];
  EXPECT_EQ(only_code(t), "repeated_pose");
}

}  // namespace
}  // namespace linkwright::motion_task_test
