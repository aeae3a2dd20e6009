#include "linkwright/core/number_check.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright::number_check_test {
namespace {

TEST(NumberCheck, TellsWhichNumberIsNone) {
  std::vector<Error> found;
  for (const double fine : {0.0, -largest_coordinate, largest_coordinate}) check_number(fine, "x", "task.x", found);
  EXPECT_TRUE(found.empty());
  using Limits = std::numeric_limits<double>;
  for (const double wrong : {-1.001 * largest_coordinate, Limits::infinity(), Limits::quiet_NaN()})
    check_number(wrong, "x", "task.x", found);
  ASSERT_EQ(found.size(), 3u);
  for (const Error& error : found) {
    EXPECT_EQ(error.code, "number_range");
    EXPECT_EQ(error.place, "task.x");
    EXPECT_EQ(error.message.substr(0, 31), "x must be a number between −1");
  }
}

}  // namespace
}  // namespace linkwright::number_check_test
