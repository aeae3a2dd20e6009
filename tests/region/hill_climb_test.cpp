#include "linkwright/region/hill_climb.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace linkwright::hill_climb_test {
namespace {

constexpr HillClimbOptions usual = {{0.01, 0.01}, 1e-6};

// The worst of several planes and bowls, as a transmission angle over some positions is.
double ridged(double u, double v) {
  return std::min(
      {1 - (u - 0.4) - 3 * (v - 0.6), 1 + 2 * (u - 0.4) + 2.5 * (v - 0.6), 1 - 0.8 * (u - 0.4) + (v - 0.6)});
}

TEST(HillClimb, FollowsSharpRidgesToTheirTop) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> anywhere(0.05, 0.95);
  const Hill hill{[](double u, double v) { return std::optional(ridged(u, v)); }, {0, 1}, {0, 1}};
  for (int i = 0; i < 200; ++i) {
    const std::array<double, 2> start = {anywhere(random), anywhere(random)};
    const HillTop top = climb_hill(hill, start, ridged(start[0], start[1]), usual);
    EXPECT_NEAR(top.score, 1, 1e-6);
    EXPECT_NEAR(top.place[0], 0.4, 1e-6);
    EXPECT_NEAR(top.place[1], 0.6, 1e-6);
    EXPECT_LT(top.evaluations, 6000);
  }
}

TEST(HillClimb, GoesOnOverTheEndOfAClosedStretchAndNeverIntoTheNext) {
  const auto wave = [](double u, double) -> std::optional<double> {
    if (!(u >= 1 && u < 2)) return 100;  // the next branch is better everywhere
    return std::cos(2 * 3.14159265358979323846 * (u - 1.02));
  };
  const Hill closed{wave, {1, 2, true}, {0, 0}}, open{wave, {1, 2, false}, {0, 0}};
  EXPECT_NEAR(climb_hill(closed, {1.9, 0}, *wave(1.9, 0), {{0.01, 0}, 1e-6}).place[0], 1.02, 1e-6);
  const HillTop end = climb_hill(open, {1.9, 0}, *wave(1.9, 0), {{0.01, 0}, 1e-6});
  EXPECT_NEAR(end.place[0], 2, 1e-6);
  EXPECT_LT(end.place[0], 2);
}

TEST(HillClimb, KeepsToWhatIsAllowed) {
  const auto inside = [](double u, double v) -> std::optional<double> {
    return std::hypot(u - 0.5, v - 0.5) < 0.3 ? std::optional(u + 0.5 * v) : std::nullopt;
  };
  const HillTop top = climb_hill({inside, {0, 1}, {0, 1}}, {0.5, 0.5}, *inside(0.5, 0.5), usual);
  EXPECT_NEAR(top.score, 0.75 + 0.3 * std::hypot(1, 0.5), 1e-4);
}

// The best place lies on a straight edge of what is allowed, wherever that points: along it one coordinate may run far
// while the other hardly changes.
TEST(HillClimb, SlidesAlongEdgesInAllDirections) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int degree = 0; degree < 360; degree += 3) {
    const double angle = 3.14159265358979323846 / 180 * (degree + share(random));
    const std::array<double, 2> normal = {std::cos(angle), std::sin(angle)};
    const auto place = [&](double across, double along) {
      return std::array{0.5 + across * normal[0] - along * normal[1], 0.5 + across * normal[1] + along * normal[0]};
    };
    const auto best = place(0.2, 0.15 * share(random));
    const auto score_at = [&](double u, double v) -> std::optional<double> {
      if ((u - 0.5) * normal[0] + (v - 0.5) * normal[1] > 0) return std::nullopt;
      return -std::hypot(u - best[0], v - best[1]);
    };
    const auto start = place(-0.1, 0.15 * share(random));
    const HillTop top = climb_hill({score_at, {0, 1}, {0, 1}}, start, *score_at(start[0], start[1]), usual);
    EXPECT_NEAR(top.score, -0.2, 1e-6) << degree;
    EXPECT_LT(top.evaluations, 6000);
  }
}

// A narrow strip across both axes: far steps along the one hit it only where the other is led along.
TEST(HillClimb, RunsAlongAStripAslant) {
  const auto strip = [](double u, double v) -> std::optional<double> {
    return std::abs(v - 0.1 - 0.8 * u) < 0.004 ? std::optional(u + v) : std::nullopt;
  };
  const HillTop top = climb_hill({strip, {0, 1}, {0, 1}}, {0.02, 0.116}, *strip(0.02, 0.116), {{0.001, 0.001}, 1e-3});
  EXPECT_NEAR(top.score, 1.904, 1e-4);
  EXPECT_LT(top.evaluations, 1500);
}

TEST(HillClimb, StaysWhereAStepIsNone) {
  const auto bowl = [](double u, double v) { return std::optional(-(u - 0.3) * (u - 0.3) - (v - 0.7) * (v - 0.7)); };
  const HillTop top = climb_hill({bowl, {0, 1}, {0, 1}}, {0.5, 0.5}, *bowl(0.5, 0.5), {{0, 0.01}, 1e-6});
  EXPECT_EQ(top.place[0], 0.5);
  EXPECT_NEAR(top.place[1], 0.7, 1e-6);
}

TEST(HillClimb, CancelledEndsAtOnceWithTheBestSoFar) {
  std::atomic<bool> cancelled = false;
  int asked = 0;
  const auto slow = [&](double u, double v) {
    cancelled = ++asked > 20;
    return std::optional(ridged(u, v));
  };
  Progress progress;
  progress.cancelled = &cancelled;
  const HillTop top = climb_hill({slow, {0, 1}, {0, 1}}, {0.1, 0.1}, ridged(0.1, 0.1), usual, progress);
  EXPECT_LT(asked, 300);
  EXPECT_GE(top.score, ridged(0.1, 0.1));
}

TEST(HillTops, AreThoseThatNoneWithinReachBetters) {
  constexpr std::size_t side = 60;
  std::mt19937_64 random(5);
  std::vector<double> score(side * side);
  for (double& s : score) s = random() % 7 == 0 ? no_score : static_cast<double>(random() % 40);
  const auto group = [](std::size_t row, std::size_t column) { return (row / 20) * 10 + column / 30; };
  for (const std::size_t reach : {1u, 3u}) {
    const auto tops = hill_tops(
        side, side, {reach, score.size()}, [&](std::size_t r, std::size_t c) { return score[r * side + c]; },
        [&](std::size_t r, std::size_t c, std::size_t r2, std::size_t c2) { return group(r, c) == group(r2, c2); });
    std::size_t expected = 0;
    for (std::size_t r = 0; r < side; ++r)
      for (std::size_t c = 0; c < side; ++c) {
        bool top = score[r * side + c] > no_score;
        for (std::size_t r2 = r < reach ? 0 : r - reach; r2 <= std::min(r + reach, side - 1); ++r2)
          for (std::size_t c2 = c < reach ? 0 : c - reach; c2 <= std::min(c + reach, side - 1); ++c2)
            top = top && !((r2 != r || c2 != c) && group(r, c) == group(r2, c2) &&
                           ranks_before({r2, c2, score[r2 * side + c2]}, {r, c, score[r * side + c]}));
        expected += top;
      }
    EXPECT_EQ(tops.size(), expected);
    EXPECT_TRUE(std::is_sorted(tops.begin(), tops.end(), ranks_before));
  }
}

}  // namespace
}  // namespace linkwright::hill_climb_test
