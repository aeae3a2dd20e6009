// Four exact positions and near ones: their solution region.

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/solved.hpp"
#include "support/tailgate.hpp"

namespace linkwright::near_answer_test {
namespace {

SynthesisOptions by_near_error() {
  SynthesisOptions options;
  options.objective = Objective::near_error;
  options.region_samples = 60;
  return options;
}

// Two positions with directions, to the first of which the body would have to come back.
TEST(NearAnswer, SaysThatNothingPassesTheNearPosesInOrder) {
  MotionTask task;
  task.poses = {{{{0, 0}, 0}, {{{1, 0.3}, 0.5}}}, {{{3, 1}, radians(30)}, {{{1, -0.3}, 0.4}}}};
  task.near = {{{{0, 0}, 0}, 2, {}, {}}};
  const MotionAnswer answer = testing::solved(task, {}, by_near_error());
  EXPECT_TRUE(answer.linkages.empty());
  EXPECT_GT(answer.meeting_requirements, 0);
  EXPECT_EQ(answer.reason.code, "none_past_near_poses");
  EXPECT_NE(answer.reason.message.find("in their order"), std::string::npos);
}

// Of many near poses maps have the errors of linkages without defects, and none of others.
TEST(NearAnswer, MeasuresManyNearPosesWhereThereAreNoDefects) {
  MotionTask task = testing::tailgate_task();
  const Pose from = task.poses[1].pose, to = task.poses[2].pose;
  for (int k = 1; k <= 13; ++k) {
    const double share = k / 14.0;
    const Pose between{from.origin + share * (to.origin - from.origin), from.angle + share * (to.angle - from.angle)};
    task.near.push_back({between, 2, {}, {}});
  }
  SynthesisOptions options = by_near_error();
  options.best = 0;
  const MotionAnswer answer = testing::solved(task, testing::tailgate_requirements(), options);
  const RegionMap& map = answer.region;
  const auto errors = map.values(measures::near_error);
  ASSERT_FALSE(errors.empty());
  int measured = 0;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t cell = map.index(row, column);
      if (!map.defects(cell).none()) {
        EXPECT_TRUE(std::isnan(errors[cell]));
        continue;
      }
      const auto error = answer.of_task->at({map.input_coordinates()[row], map.output_coordinates()[column]});
      if (!error || !std::isfinite(*error)) continue;
      EXPECT_NEAR(errors[cell], *error, 1e-5 * (1 + *error));
      ++measured;
    }
  EXPECT_GT(measured, 50);
}

}  // namespace
}  // namespace linkwright::near_answer_test
