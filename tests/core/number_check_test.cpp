#include "core/number_check.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"

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

TEST(NumberCheck, TakesTheLargestAngleThatFilesMayGive) {
  std::vector<Error> found;
  for (const double degrees : {0.0, -largest_coordinate, largest_coordinate})
    check_angle(radians(degrees), "theta_deg", "task.theta_deg", found);
  EXPECT_TRUE(found.empty());
  for (const double wrong : {1.000'001 * radians(largest_coordinate), std::numeric_limits<double>::quiet_NaN()})
    check_angle(wrong, "theta_deg", "task.theta_deg", found);
  EXPECT_EQ(found.size(), 2u);
}

}  // namespace
}  // namespace linkwright::number_check_test
