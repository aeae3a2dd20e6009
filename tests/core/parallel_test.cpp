#include "linkwright/core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>
#include <vector>

namespace linkwright::parallel_test {
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

TEST(ParallelFor, PassesOnWhatABodyThrows) {
  std::atomic<int> calls = 0;
  const auto fails = [&](std::size_t begin, std::size_t /*end*/) {
    ++calls;
    if (begin == 0) throw std::runtime_error("no memory");
  };
  EXPECT_THROW(parallel_for(1000, 0, fails), std::runtime_error);
  EXPECT_THROW(parallel_for(1000, 1, fails), std::runtime_error);
  EXPECT_GT(calls, 0);
}

// On a busy machine helpers come late: nobody waits for one that has not begun.
TEST(ParallelFor, DoesNotWaitForHelpersThatDoNotCome) {
  using namespace std::chrono_literals;
  const auto wait_until = [](const auto& happened) {
    for (int i = 0; i < 10'000 && !happened(); ++i) std::this_thread::sleep_for(1ms);
    return happened();
  };
  const int threads = available_threads();
  std::atomic<int> held = 0;
  std::atomic<bool> released = false, gave_up = false;
  std::thread holder([&] {  // all helpers
    parallel_for(static_cast<std::size_t>(threads), 0, [&](std::size_t, std::size_t) {
      ++held;
      if (!wait_until([&] { return released.load(); })) gave_up = true;
    });
  });
  wait_until([&] { return held == threads; });
  std::atomic<int> total = 0;
  parallel_for(100, 0, [&](std::size_t begin, std::size_t end) { total += static_cast<int>(end - begin); });
  EXPECT_EQ(total, 100);
  EXPECT_FALSE(gave_up);
  released = true;
  holder.join();
}

TEST(ParallelFor, KnowsOfAtLeastOneThread) { EXPECT_GE(available_threads(), 1); }

}  // namespace
}  // namespace linkwright::parallel_test
