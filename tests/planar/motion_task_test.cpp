#include "linkwright/planar/motion_task.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

MotionTask task(const std::vector<Pose>& poses) {
  MotionTask result;
  for (const Pose& pose : poses) result.poses.push_back({pose, {}});
  return result;
}

const std::vector<Pose> good = {{{0, 0}, 0}, {{1, 0}, 0.4}, {{2, 1}, 0.9}, {{2, 3}, 1.7}};

std::string only_code(const MotionTask& t) {
  const auto found = mistakes_in(t);
  return found.size() == 1 ? found[0].code : "not one mistake";
}

TEST(MotionTask, FourDifferentPosesAreFine) { EXPECT_TRUE(mistakes_in(task(good)).empty()); }

TEST(MotionTask, CountIsNamed) {
  EXPECT_EQ(only_code(task({good[0], good[1], good[2]})), "too_few_poses");
  EXPECT_EQ(only_code(task({})), "too_few_poses");
  EXPECT_EQ(only_code(task({good[0], good[1], good[2], good[3], {{9, 9}, 0}})), "too_many_poses");
}

TEST(MotionTask, RepetitionsAreFoundModuloWholeTurns) {
  EXPECT_EQ(only_code(task({good[0], good[1], good[2], good[1]})), "repeated_pose");
  EXPECT_EQ(only_code(task({good[0], good[1], good[2], {good[0].origin, two_pi}})), "repeated_pose");
  const auto found = mistakes_in(task({good[0], good[1], good[1], good[1]}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place, "task.poses[2]");
  EXPECT_EQ(found[1].place, "task.poses[3]");
}

TEST(MotionTask, ClosePosesAreNotRepetitions) {
  EXPECT_TRUE(mistakes_in(task({good[0], {{1e-6, 0}, 1e-6}, good[2], good[3]})).empty());
}

TEST(MotionTask, NumbersMustBeFiniteAndReasonable) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 2e9}) {
    MotionTask t = task(good);
    t.poses[2].pose.origin = {0, bad};
    const auto found = mistakes_in(t);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].place, "task.poses[2].y");
    t = task(good);
    t.poses[3].pose.angle = bad;
    ASSERT_EQ(mistakes_in(t).size(), 1u);
    EXPECT_EQ(mistakes_in(t)[0].place, "task.poses[3].theta_deg");
  }
}

TEST(MotionTask, DerivativesAreRefusedHonestly) {
  MotionTask t = task(good);
  t.poses[0].derivatives.push_back({{1, 0}, 0.2});
  EXPECT_EQ(only_code(t), "not_available");
}

}  // namespace
}  // namespace linkwright
