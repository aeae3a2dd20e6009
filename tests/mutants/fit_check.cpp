// What a fit by least squares stands on: where a linkage's states are at angles of its input, and where a small change
// takes the point. Random linkages; a start near one whose points are the target goes back to it, or it is wrong.

#include <cmath>
#include <cstdio>
#include <vector>

#include "approximate/timed_least_squares.hpp"
#include "support/random_four_bar.hpp"

using namespace linkwright;

int main() {
  testing::RandomFourBars draw(11);
  int wrong = 0, trials = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Point> points(12), turns;
    const std::vector<double> weights(12, 1);
    for (int j = 0; j < 12; ++j) turns.push_back(direction(0.5 * j));
    TimedTask task{{points, weights, {}}, turns};
    task.limits.min_sine = trial % 2 == 0 ? 0 : 0.2;
    TimedStart start;
    start.branch = trial % 3 == 0 ? -1 : 1;
    start.reversed = trial % 5 == 0;
    start.linkage = {{0.1, 0.2},
                     {2.2, -0.3},
                     draw.uniform(0.4, 0.8),
                     draw.uniform(1.8, 2.4),
                     draw.uniform(1.4, 2),
                     {0.9, draw.uniform(-1, 1)}};
    start.datum = direction(draw.uniform(0, 6.28));
    if (!place_states(task, start)) continue;
    ++trials;
    for (std::size_t j = 0; j < 12; ++j) {
      points[j] = traced_point(start.linkage, start.states[j]);
      const LoopGradient loop(start.linkage, start.states[j]);
      if (!(std::abs(loop.f) < 1e-12 && start.branch * cross(start.states[j].u, loop.g) > 0)) ++wrong;
    }
    const TimedStart exact = start;
    const auto off = [&](double most) { return draw.uniform(-most, most); };
    start.linkage.a0 += Point{off(0.02), off(0.02)};
    start.linkage.b0 += Point{off(0.02), off(0.02)};
    start.linkage.a += off(0.02);
    start.linkage.h += off(0.02);
    start.linkage.b += off(0.02);
    start.linkage.p += Point{off(0.02), off(0.02)};
    start.datum *= direction(off(0.02));
    if (!place_states(task, start)) continue;
    evaluate(task, start);
    improve(task, start, 12);
    evaluate(task, start);
    const bool is_back = start.squares < 1e-20;
    double least = 1;
    for (const LoopState& at : exact.states)
      least = std::min(least, std::abs(cross(at.u, LoopGradient(exact.linkage, at).g)) / exact.linkage.b);
    if (!is_back && least > task.limits.min_sine + 0.05) ++wrong;
  }
  std::printf("%d of %d wrong\n", wrong, trials);
  return wrong > 0 || trials < 100 ? 1 : 0;
}
