#include "approximate/timed_scan.hpp"

#include <gtest/gtest.h>

#include "approximate/timed_scan_kernel.hpp"
#include "linkwright/core/angle.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::timed_scan_test {
namespace {

// A random target at random angles, its points about their weighted mean.
struct Drawn {
  std::vector<Point> points, turns;
  std::vector<double> weights;

  explicit Drawn(std::uint64_t seed) {
    testing::RandomFourBars draw(seed);
    const int count = 6 + draw.below(19);
    double angle = 0;
    for (int j = 0; j < count; ++j) {
      points.emplace_back(draw.uniform(-2, 2), draw.uniform(-2, 2));
      weights.push_back(draw.uniform(0.1, 2));
      turns.push_back(direction(angle));
      angle += draw.uniform(0.01, 0.25);
    }
  }
  [[nodiscard]] TimedTask task() const { return {{points, weights, {}}, turns}; }
  [[nodiscard]] double weight_sum() const {
    double sum = 0;
    for (const double w : weights) sum += w;
    return sum;
  }
};

TEST(TimedScan, KnowsTheErrorOfEachCell) {
  int cells_seen = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Drawn drawn(seed);
    const TimedTask task = drawn.task();
    for (const bool absolute : {false, true}) {
      for (const TimedCell& cell : scan_ratios(task, absolute, scanned_ratios(20, false), Simd::automatic)) {
        auto start = timed_start(task, absolute, cell);
        ASSERT_TRUE(start);
        evaluate(task, *start);
        EXPECT_NEAR(start->squares / drawn.weight_sum(), cell.squares, 1e-4 * cell.squares + 1e-8) << seed << absolute;
        ++cells_seen;
      }
    }
  }
  EXPECT_GT(cells_seen, 500);
}

TEST(TimedScan, GivesTheBestPointAndPlaceOfAShape) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Drawn drawn(seed);
    const TimedTask task = drawn.task();
    testing::RandomFourBars draw(seed);
    for (const TimedCell& cell : scan_ratios(task, false, scanned_ratios(10, false), Simd::automatic)) {
      auto best = timed_start(task, false, cell);
      ASSERT_TRUE(best);
      evaluate(task, *best);
      for (int trial = 0; trial < 10; ++trial) {  // moved, turned, sized or with another point it is no better
        TimedStart other = *best;
        const double size = 1 + draw.uniform(-0.02, 0.02);
        const Point turn = size * direction(draw.uniform(-0.02, 0.02));
        const Point shift{draw.uniform(-0.02, 0.02), draw.uniform(-0.02, 0.02)};
        CouplerLinkage& l = other.linkage;
        l = {turn * l.a0 + shift, turn * l.b0 + shift,
             size * l.a,          size * l.h,
             size * l.b,          size * l.p + Point{draw.uniform(-0.02, 0.02), draw.uniform(-0.02, 0.02)}};
        other.datum *= turn / size;
        ASSERT_TRUE(place_states(task, other));
        evaluate(task, other);
        EXPECT_GE(other.squares, best->squares * (1 - 1e-9));
      }
    }
  }
}

TEST(TimedScanKernel, HasTheSameBitsOnAllInstructionSets) {
  testing::RandomFourBars draw(5);
  TimedBlock block{};
  block.count = TimedBlock::size;
  block.points = 17;
  for (int j = 0; j < block.points; ++j) {
    const Point turn = direction(0.2 * j);
    block.turn[j][0] = turn.real();
    block.turn[j][1] = turn.imag();
    block.point[j][0] = draw.uniform(-1, 1);
    block.point[j][1] = draw.uniform(-1, 1);
    block.weight[j] = 1. / 17;
  }
  for (int k = 0; k < TimedBlock::size; ++k) {
    block.ground[k] = draw.uniform(0.2, 5);
    block.coupler[k] = draw.uniform(0.2, 5);
    block.output[k] = draw.uniform(0.2, 5);
    const Point phase = direction(draw.uniform(0, two_pi));
    block.phase[0][k] = phase.real();
    block.phase[1][k] = phase.imag();
  }
  for (const bool absolute : {false, true}) {
    block.absolute = absolute;
    TimedBlock scalar = block;
    timed_scan_kernel.for_simd(Simd::scalar)(scalar);
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
      if (!is_supported(simd)) continue;
      TimedBlock other = block;
      timed_scan_kernel.for_simd(simd)(other);
      for (int variant = 0; variant < TimedBlock::variants; ++variant)
        for (int k = 0; k < TimedBlock::size; ++k)
          EXPECT_EQ(other.squares[variant][k], scalar.squares[variant][k]) << name(simd) << variant << " " << k;
    }
  }
}

TEST(TimedScan, DrawsShapesWhoseInputTurnsFully) {
  for (const BarRatios& r : scanned_ratios(200, true)) {
    const LinkLengths lengths{r.ground, 1, r.coupler, r.output};
    EXPECT_LT(lengths.shortest() + lengths.longest(), lengths.perimeter() / 2);
    EXPECT_TRUE(lengths.shortest() == 1 || lengths.shortest() == r.ground);
  }
}

}  // namespace
}  // namespace linkwright::timed_scan_test
