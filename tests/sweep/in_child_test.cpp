#include "in_child.hpp"

#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <stdexcept>

namespace linkwright {
namespace {

using std::chrono_literals::operator""s;

TEST(InChild, TellsHowItsWorkEnded) {
  EXPECT_EQ(in_child(60s, [] { return 0; }).status, 0);
  EXPECT_EQ(in_child(60s, [] { return 2; }).status, 2);
  EXPECT_EQ(in_child(60s, []() -> int { throw std::runtime_error("thrown on purpose"); }).status, 1);
}

TEST(InChild, OutlivesWhatCrashes) {
  const ChildEnd end = in_child(60s, [] {
    std::signal(SIGSEGV, SIG_DFL);  // sanitizers would tell of it
    return std::raise(SIGSEGV);
  });
  EXPECT_EQ(end.status, std::nullopt);
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_TRUE(end.crashed());
}

TEST(InChild, KnowsWhatOthersEnded) {
  for (const int signal : {SIGKILL, SIGPIPE, SIGTERM}) {
    const ChildEnd end = in_child(60s, [signal] {
      std::signal(signal, SIG_DFL);
      return std::raise(signal);
    });
    EXPECT_EQ(end.status, std::nullopt);
    EXPECT_EQ(end.signal, signal);
    EXPECT_FALSE(end.crashed());
  }
}

TEST(InChild, EndsWhatDoesNotEnd) {
  volatile bool goes_on = true;
  const ChildEnd end = in_child(1s, [&] {
    while (goes_on) {
    }
    return 0;
  });
  EXPECT_EQ(end.status, std::nullopt);
  EXPECT_TRUE(end.crashed());
}

TEST(InChild, ChangesNothingHere) {
  int number = 1;
  EXPECT_EQ(in_child(60s, [&] { return ++number; }).status, 2);
  EXPECT_EQ(number, 1);
}

}  // namespace
}  // namespace linkwright
