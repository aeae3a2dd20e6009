#include "region/improved_linkage.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/synthesis/solve.hpp"
#include "support/tailgate.hpp"

namespace linkwright::improved_linkage_test {
namespace {

TaskFamily given_by(const MotionTask& task) { return task_family(task, {}, Objective::min_transmission_angle); }

FourBarSolution at(const TaskFamily& given, MapPoint place) { return *make_four_bar(given, place, true, false); }

TEST(ImprovedLinkage, ClimbsToABetterOneOfTheSameType) {
  const MotionTask task = testing::tailgate_task();
  const TaskFamily given = given_by(task);
  const Requirements wanted = testing::tailgate_requirements();
  const MapPoint start{1.3125, 1.1125};
  const auto top = improved_linkage(*given.family, wanted, Objective::min_transmission_angle, start);
  ASSERT_TRUE(top);
  const FourBarSolution before = at(given, start), after = at(given, *top);
  EXPECT_GT(after.report.min_transmission_angle, before.report.min_transmission_angle);
  EXPECT_EQ(after.report.type, before.report.type);
  EXPECT_TRUE(after.report.defects.none());
  EXPECT_LE(after.lengths.longest(), 450);
  const auto again = improved_linkage(*given.family, wanted, Objective::min_transmission_angle, *top);
  const double angle = after.report.min_transmission_angle;
  EXPECT_NEAR(again ? at(given, *again).report.min_transmission_angle : angle, angle, 1e-3) << "at the top";
}

TEST(ImprovedLinkage, DoesNotStartOutsideTheRequirements) {
  const MotionTask task = testing::tailgate_task();
  Requirements wanted = testing::tailgate_requirements();
  wanted.max_length = 200;
  EXPECT_FALSE(improved_linkage(*given_by(task).family, wanted, Objective::min_transmission_angle, {1.3125, 1.1125}));
}

}  // namespace
}  // namespace linkwright::improved_linkage_test
