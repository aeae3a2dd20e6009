#include "planar/pivot_search.hpp"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "planar/path_family.hpp"
#include "support/path_case.hpp"

namespace linkwright::pivot_search_test {
namespace {

/// Five points of a mixer's blade, and where its crank may stand.
PathTask mixer_in(const Box& box) {
  PathTask task = testing::path_case("dough_mixer_five_points").task;
  task.pivots = {};
  task.box = box;
  return task;
}

PivotSearchOptions wish(int effort) {
  PivotSearchOptions options;
  options.requirements.min_transmission_angle = radians(35);
  options.effort = effort;
  return options;
}

/// Of the map of a pivot 1 − cos of the largest least transmission angle, by its cells; 0 where none is free of
/// defects.
double best_versine(PathTask task, Point pivot, const PivotSearchOptions& options, int samples) {
  task.box.reset();
  task.pivots.input = pivot;
  if (!mistakes_in(task).empty()) return 0;
  const TaskFamily given = task_family(task, options.requirements, options.objective);
  RegionMap map;
  given.family->classify(map, given.family->samples(Side::input, samples, Spacing::coordinate),
                         given.family->samples(Side::output, samples, Spacing::coordinate), true);
  double best = 0;
  for (std::size_t cell = 0; cell < map.rows() * map.columns(); ++cell)
    if (map.defects(cell).none())
      best = std::max(best, static_cast<double>(map.values(measures::min_transmission_angle)[cell]));
  return best;
}

constexpr Box around = {-150, 250, -150, 350};

TEST(PivotSearch, FindsAPlaceAsGoodAsAGridOfMaps) {
  constexpr int side = 7, samples = 12;
  const PathTask task = mixer_in(around);
  const PivotSearchOptions options = wish(20'000);
  const PivotSearchResult found = search_for_pivot(task, options);
  EXPECT_TRUE(found.meets);
  EXPECT_TRUE(around.contains(found.pivot));
  EXPECT_GT(found.meeting, 0);
  double best = 0;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const Point pivot{around.x_low + (i + 0.5) / side * (around.x_high - around.x_low),
                        around.y_low + (k + 0.5) / side * (around.y_high - around.y_low)};
      best = std::max(best, best_versine(task, pivot, options, samples));
    }
  EXPECT_GT(best, 0);
  EXPECT_GE(best_versine(task, found.pivot, options, 60), best - 0.02);
}

// One place with sixteen arms is drawn, and few of them are so good before they are moved.
TEST(PivotSearch, MovesWhatItDrew) {
  int meeting = 0, drawn_so = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    PivotSearchOptions options = wish(16);
    options.requirements.min_transmission_angle = radians(60);
    options.seed = seed;
    const PivotSearchResult found = search_for_pivot(mixer_in(around), options);
    meeting += found.meets ? 1 : 0;
    drawn_so += found.meeting > 0 ? 1 : 0;
  }
  EXPECT_LE(drawn_so, 4);
  EXPECT_GE(meeting, drawn_so + 2);
}

TEST(PivotSearch, FindsTheSameWhateverTheThreads) {
  const PathTask task = mixer_in(around);
  PivotSearchOptions options = wish(3000);
  options.threads = 1;
  const Point alone = search_for_pivot(task, options).pivot;
  options.threads = 2;
  EXPECT_EQ(search_for_pivot(task, options).pivot, alone);
  options.seed = 2;
  EXPECT_NE(search_for_pivot(task, options).pivot, alone);
}

TEST(PivotSearch, StaysInANarrowBoxAndOffThePoints) {
  const Point point = mixer_in(around).points[1].point;
  const Box narrow = {point.real() - 1e-3, point.real() + 1e-3, point.imag() - 1e-3, point.imag() + 1e-3};
  EXPECT_TRUE(narrow.contains(search_for_pivot(mixer_in(narrow), wish(500)).pivot));
}

TEST(PivotSearch, SaysWhenNoneMeetsTheRequirements) {
  PivotSearchOptions options = wish(3000);
  options.requirements.max_length = 1e-3;
  const PivotSearchResult found = search_for_pivot(mixer_in(around), options);
  EXPECT_FALSE(found.meets);
  EXPECT_EQ(found.meeting, 0);
  EXPECT_EQ(found.places, 3000 / 16);
}

TEST(PivotSearch, StopsWhenItIsCancelled) {
  const std::atomic<bool> cancelled = true;
  EXPECT_EQ(search_for_pivot(mixer_in(around), wish(10'000'000), {{}, &cancelled}).places, 0);
}

}  // namespace
}  // namespace linkwright::pivot_search_test
