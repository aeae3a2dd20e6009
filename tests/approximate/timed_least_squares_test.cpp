#include "approximate/timed_least_squares.hpp"

#include <gtest/gtest.h>

#include "approximate/timed_scan.hpp"
#include "linkwright/core/angle.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::timed_least_squares_test {
namespace {

TEST(TimedLeastSquares, PlacesStatesThatCloseAtThePrescribedAngles) {
  testing::RandomFourBars draw(3);
  int placed_all = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Point> points(10), turns;
    const std::vector<double> weights(10, 1);
    for (int j = 0; j < 10; ++j) turns.push_back(direction(0.6 * j));
    const TimedTask task{{points, weights, {}}, turns};
    TimedStart start;
    start.linkage = {{draw.uniform(-1, 1), draw.uniform(-1, 1)},
                     {draw.uniform(2, 3), draw.uniform(-1, 1)},
                     draw.uniform(0.3, 1),
                     draw.uniform(1, 3),
                     draw.uniform(1, 3),
                     {0.4, 0.7}};
    start.branch = trial % 2 == 0 ? 1 : -1;
    start.reversed = trial % 3 == 0;
    start.datum = direction(draw.uniform(0, two_pi));
    if (!place_states(task, start)) continue;
    ++placed_all;
    for (std::size_t j = 0; j < 10; ++j) {
      const LoopState& at = start.states[j];
      const LoopGradient loop(start.linkage, at);
      EXPECT_NEAR(loop.f, 0, 1e-13);
      EXPECT_GT(start.branch * cross(at.u, loop.g), 0);
      EXPECT_NEAR(std::abs(at.e - start.datum * (start.reversed ? std::conj(turns[j]) : turns[j])), 0, 1e-15);
    }
  }
  EXPECT_GT(placed_all, 50);
}

// From near an exact linkage back to it: the last steps are quadratic, so that wrong derivatives do not get there.
TEST(TimedLeastSquares, ReturnsToAnExactLinkage) {
  testing::RandomFourBars draw(8);
  int returned = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Point> points(12), turns;
    const std::vector<double> weights(12, 1);
    for (int j = 0; j < 12; ++j) turns.push_back(direction(0.5 * j));
    TimedTask task{{points, weights, {}}, turns};
    task.limits.min_sine = 0.1;
    TimedStart start;
    start.linkage = {{0.1, 0.2},           {2.2, -0.3}, draw.uniform(0.4, 0.8), draw.uniform(1.8, 2.4),
                     draw.uniform(1.4, 2), {0.9, 0.8}};
    start.datum = direction(draw.uniform(0, two_pi));
    if (!place_states(task, start)) continue;
    for (std::size_t j = 0; j < 12; ++j) points[j] = traced_point(start.linkage, start.states[j]);
    TimedStart near = start;
    near.linkage.a0 += Point{draw.uniform(-0.05, 0.05), draw.uniform(-0.05, 0.05)};
    near.linkage.h += draw.uniform(-0.05, 0.05);
    near.linkage.p += Point{draw.uniform(-0.05, 0.05), draw.uniform(-0.05, 0.05)};
    near.datum *= direction(draw.uniform(-0.05, 0.05));
    ASSERT_TRUE(place_states(task, near));
    evaluate(task, near);
    improve(task, near, 40);
    EXPECT_LT(near.squares, 1e-24) << trial;
    ++returned;
  }
  EXPECT_GT(returned, 10);
}

TEST(TimedLeastSquares, LeavesAHeldDatumAlone) {
  std::vector<Point> points = {{1, 0}, {0.6, 0.9}, {-0.4, 1}, {-1, 0.2}, {-0.7, -0.8}, {0.3, -1}}, turns;
  const std::vector<double> weights(6, 1);
  for (int j = 0; j < 6; ++j) turns.push_back(direction(j));
  const TimedTask task{{points, weights, {}}, turns};
  const auto cells = scan_ratios(task, true, scanned_ratios(50, true), Simd::automatic);
  ASSERT_FALSE(cells.empty());
  auto start = timed_start(task, true, cells.front());
  ASSERT_TRUE(start);
  evaluate(task, *start);
  const double before = start->cost();
  improve(task, *start, 30);
  EXPECT_EQ(start->datum, Point(1, 0));
  EXPECT_LT(start->cost(), before);
}

}  // namespace
}  // namespace linkwright::timed_least_squares_test
