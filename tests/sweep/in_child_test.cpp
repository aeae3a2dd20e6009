#include "in_child.hpp"

#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <stdexcept>

namespace linkwright {
namespace {

using std::chrono_literals::operator""s;

TEST(InChild, TellsHowItsWorkEnded) {
  EXPECT_EQ(in_child(60s, [] { return 0; }), 0);
  EXPECT_EQ(in_child(60s, [] { return 2; }), 2);
  EXPECT_EQ(in_child(60s, []() -> int { throw std::runtime_error("thrown on purpose"); }), 1);
}

TEST(InChild, OutlivesWhatCrashes) {
  EXPECT_EQ(in_child(60s, [] { return std::raise(SIGKILL); }), std::nullopt);
  EXPECT_EQ(in_child(60s,
                     [] {
                       std::signal(SIGSEGV, SIG_DFL);  // sanitizers would tell of it
                       return std::raise(SIGSEGV);
                     }),
            std::nullopt);
}

TEST(InChild, EndsWhatDoesNotEnd) {
  volatile bool goes_on = true;
  EXPECT_EQ(in_child(1s,
                     [&] {
                       while (goes_on) {
                       }
                       return 0;
                     }),
            std::nullopt);
}

TEST(InChild, ChangesNothingHere) {
  int number = 1;
  EXPECT_EQ(in_child(60s, [&] { return ++number; }), 2);
  EXPECT_EQ(number, 1);
}

}  // namespace
}  // namespace linkwright
