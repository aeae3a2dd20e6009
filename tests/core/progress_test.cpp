#include "linkwright/core/progress.hpp"

#include <atomic>
#include <gtest/gtest.h>

namespace linkwright::progress_test {
namespace {

TEST(Progress, NeedsNobodyToListen) {
  const Progress progress;
  progress(0.5);
  EXPECT_FALSE(progress.is_cancelled());
}

TEST(Progress, TellsHowMuchIsDone) {
  double last = 0;
  const Progress progress{[&](double done) { last = done; }, nullptr};
  progress(0.25);
  EXPECT_EQ(last, 0.25);
}

TEST(Progress, LearnsThatItShouldStop) {
  std::atomic<bool> cancelled = false;
  const Progress progress{{}, &cancelled};
  EXPECT_FALSE(progress.is_cancelled());
  cancelled = true;
  EXPECT_TRUE(progress.is_cancelled());
}

}  // namespace
}  // namespace linkwright::progress_test
