#include "linkwright/planar/feasible_offsets.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/tailgate.hpp"

namespace linkwright::feasible_offsets_test {
namespace {

using testing::tailgate_requirements;
using testing::tailgate_task;

std::int64_t meeting(const MotionTask& task, const Requirements& wanted, int samples) {
  SynthesisOptions options;
  options.region_samples = samples;
  options.best = 0;
  return findings(*solve(task, wanted, options)).meeting_requirements;
}

TEST(FeasibleOffsets, CountsWhatSolvingEachMovedTaskFinds) {
  const FeasibleOffsets halo(tailgate_task(), tailgate_requirements(), Spacing::coordinate, 40);
  const auto counts = halo.moved(2, 40, 5);
  const auto offsets = offset_values(40, 5);
  ASSERT_EQ(counts.size(), 25u);
  EXPECT_EQ(offsets, (std::vector<double>{-40, -20, 0, 20, 40}));
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 5; ++x) {
      MotionTask task = tailgate_task();
      task.poses[2].pose.origin += Point{offsets[x], offsets[y]};
      EXPECT_EQ(counts[y * 5 + x], meeting(task, tailgate_requirements(), 40));
    }
  EXPECT_GT(counts[2 * 5 + 2], 0u);
  EXPECT_EQ(counts[2 * 5 + 4], 0u) << "nothing is left 40 to the right";
}

TEST(FeasibleOffsets, CountsTurns) {
  Requirements any;
  const FeasibleOffsets halo(tailgate_task(), any, Spacing::coordinate, 30);
  const auto counts = halo.turned(1, radians(10), 3);
  MotionTask task = tailgate_task();
  task.poses[1].pose.angle += radians(10);
  EXPECT_EQ(counts[2], meeting(task, any, 30));
}

TEST(FeasibleOffsets, RefusedAndDegenerateTasksCountNothing) {
  MotionTask task = tailgate_task();
  task.poses[1].pose = task.poses[0].pose;
  task.poses[1].pose.origin += Point{10, 0};
  const FeasibleOffsets halo(task, {}, Spacing::coordinate, 20);
  EXPECT_EQ(halo.moved(1, 10, 3)[3], 0u) << "there it repeats the first pose";
}

}  // namespace
}  // namespace linkwright::feasible_offsets_test
