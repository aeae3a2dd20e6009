#include "linkwright/core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <vector>

namespace linkwright {
namespace {

TEST(ParallelFor, CoversEveryIndexOnce) {
  for (const int threads : {0, 1, 2, 7, -3}) {
    for (const std::size_t count : {1, 2, 3, 64, 1000, 4097}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; })) << count << ' ' << threads;
    }
  }
}

TEST(ParallelFor, CallsNothingForNothing) {
  parallel_for(0, 0, [](std::size_t, std::size_t) { ADD_FAILURE(); });
}

TEST(ParallelFor, OfOneThreadIsOneCallOfTheCaller) {
  std::vector<std::pair<std::size_t, std::size_t>> calls;  // no lock: it would be a race otherwise
  parallel_for(100, 1, [&](std::size_t begin, std::size_t end) { calls.emplace_back(begin, end); });
  EXPECT_EQ(calls, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 100}}));
}

TEST(ParallelFor, NestsWithoutLoss) {
  std::atomic<int> total = 0;
  parallel_for(20, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      parallel_for(30, 0, [&](std::size_t from, std::size_t to) { total += static_cast<int>(to - from); });
  });
  EXPECT_EQ(total, 600);
}

TEST(ParallelFor, KnowsOfAtLeastOneThread) { EXPECT_GE(available_threads(), 1); }

}  // namespace
}  // namespace linkwright
