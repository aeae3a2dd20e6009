#include "linkwright/planar/improved_linkage.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/planar/motion_synthesis.hpp"
#include "support/tailgate.hpp"

namespace linkwright {
namespace {

FourBarSolution at(const MotionTask& task, const TaskCurve& given, RegionPlace place) {
  const WorkingFrame& frame = given.conditions.frame;
  return *make_four_bar(task, frame, frame.to_user(given.curve->dyad(place.input)),
                        frame.to_user(given.curve->dyad(place.output)), true, false);
}

TEST(ImprovedLinkage, ClimbsToABetterOneOfTheSameType) {
  const MotionTask task = testing::tailgate_task();
  const TaskCurve given = task_curve(task);
  const Requirements wanted = testing::tailgate_requirements();
  const RegionPlace start{1.3125, 1.1125};
  const auto top = improved_linkage(task, given, wanted, Objective::min_transmission_angle, start);
  ASSERT_TRUE(top);
  const FourBarSolution before = at(task, given, start), after = at(task, given, *top);
  EXPECT_LT(after.report.worst_transmission_cosine, before.report.worst_transmission_cosine);
  EXPECT_EQ(after.report.type, before.report.type);
  EXPECT_TRUE(after.report.defects.none());
  EXPECT_LE(after.lengths.longest(), 450);
  const auto again = improved_linkage(task, given, wanted, Objective::min_transmission_angle, *top);
  const double cosine = after.report.worst_transmission_cosine;
  EXPECT_NEAR(again ? at(task, given, *again).report.worst_transmission_cosine : cosine, cosine, 1e-3) << "at the top";
}

TEST(ImprovedLinkage, DoesNotStartOutsideTheRequirements) {
  const MotionTask task = testing::tailgate_task();
  Requirements wanted = testing::tailgate_requirements();
  wanted.max_length = 200;
  EXPECT_FALSE(improved_linkage(task, task_curve(task), wanted, Objective::min_transmission_angle, {1.3125, 1.1125}));
}

}  // namespace
}  // namespace linkwright
