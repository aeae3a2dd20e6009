#include "linkwright/solve/halo.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"
#include "support/tailgate.hpp"

namespace linkwright::halo_test {
namespace {

using testing::tailgate_requirements;
using testing::tailgate_task;

Problem tailgate() {
  Problem problem;
  problem.task = tailgate_task();
  problem.requirements = tailgate_requirements();
  return problem;
}
Problem loader() { return testing::example("loader_bucket_chain.json", 40); }

std::int64_t meeting(Problem problem, int samples) {
  problem.options.region_samples = samples;
  problem.options.best = 0;
  return findings(*solve(problem)).meeting_requirements;
}

TEST(Halo, CountsWhatSolvingEachMovedTaskFinds) {
  const auto counts = halo(tailgate(), {2, false, 40, 5, 40});
  const auto offsets = offset_values(40, 5);
  ASSERT_EQ(counts.size(), 25u);
  EXPECT_EQ(offsets, (std::vector<double>{-40, -20, 0, 20, 40}));
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 5; ++x) {
      Problem moved = tailgate();
      std::get<MotionTask>(moved.task).poses[2].pose.origin += Point{offsets[x], offsets[y]};
      EXPECT_EQ(counts[y * 5 + x], meeting(moved, 40));
    }
  EXPECT_GT(counts[2 * 5 + 2], 0u);
  EXPECT_EQ(counts[2 * 5 + 4], 0u) << "nothing is left 40 to the right";
}

TEST(Halo, CountsTurns) {
  Problem any = tailgate();
  any.requirements = {};
  const auto counts = halo(any, {1, true, radians(10), 3, 30});
  std::get<MotionTask>(any.task).poses[1].pose.angle += radians(10);
  EXPECT_EQ(counts[2], meeting(any, 30));
}

TEST(Halo, RefusedAndDegenerateTasksCountNothing) {
  Problem problem = tailgate();
  auto& task = std::get<MotionTask>(problem.task);
  task.poses[1].pose = task.poses[0].pose;
  task.poses[1].pose.origin += Point{10, 0};
  EXPECT_EQ(halo(problem, {1, false, 10, 3, 20})[3], 0u) << "there it repeats the first pose";
}

TEST(Halo, OfWhatATaskHasNotIsEmpty) {
  EXPECT_TRUE(halo(tailgate(), {4, false, 40, 5, 40}).empty());
  EXPECT_TRUE(halo(tailgate(), {-1, false, 40, 5, 40}).empty());
  EXPECT_TRUE(halo(loader(), {7, false, 40, 5, 40}).empty());
  EXPECT_TRUE(halo(testing::example("log_generator.json", 40), {0, false, 40, 5, 40}).empty());
}

TEST(Halo, HoldsToALimitOfTheToleranceError) {
  Problem problem = tailgate();
  const auto counts = halo(problem, {2, false, 0, 1, 40});
  problem.options.tolerances = Tolerances{};
  problem.options.tolerances->length = LengthTolerances::all(0.2);
  problem.requirements.max_tolerance_error = 0.2;
  const auto exact = halo(problem, {2, false, 0, 1, 40});
  EXPECT_LT(exact[0], counts[0]);
  EXPECT_EQ(exact[0], meeting(problem, 40));
}

// Six-bars are counted by a map that is a quarter as fine.
TEST(Halo, OfSixBarsCountsForPosesAndForHingesOfTheChain) {
  constexpr int asked = 10, of_the_map = 10;
  for (const int part : {1, 4, 5, 6}) {
    const auto counts = halo(loader(), {part, false, 120, 3, asked});
    ASSERT_EQ(counts.size(), 9u);
    Problem moved = loader();
    auto& task = std::get<SixBarTask>(moved.task);
    const Point by = {120, -120};
    if (part < 4)
      task.poses[1].pose.origin += by;
    else
      *std::array<Point*, 3>{&task.chain->a, &task.chain->b, &task.chain->d}[static_cast<std::size_t>(part) - 4] += by;
    const bool is_one = mistakes_in(moved.task).empty();
    EXPECT_EQ(counts[2], is_one ? meeting(moved, 4 * of_the_map) : 0) << part;
    EXPECT_EQ(counts[4], meeting(loader(), 4 * of_the_map)) << part;
  }
}

TEST(Halo, KeepsTheElbowsWhereBChangesSides) {
  Problem problem = loader();
  auto& chain = *std::get<SixBarTask>(problem.task).chain;
  const auto plain = halo(problem, {5, false, 4000, 3, 40});
  chain.assembly_mode.fill(chain.assembly_mode_in_position_1());
  EXPECT_EQ(halo(problem, {5, false, 4000, 3, 40}), plain);
}

}  // namespace
}  // namespace linkwright::halo_test
