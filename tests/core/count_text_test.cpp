#include "linkwright/core/count_text.hpp"

#include <gtest/gtest.h>

namespace linkwright::count_text_test {
namespace {

TEST(CountText, IsGroupedInThrees) {
  EXPECT_EQ(grouped_text(0), "0");
  EXPECT_EQ(grouped_text(999), "999");
  EXPECT_EQ(grouped_text(1000), "1 000");
  EXPECT_EQ(grouped_text(159600), "159 600");
  EXPECT_EQ(grouped_text(-1234567), "-1 234 567");
}

TEST(CountText, LimitsAreWrittenAsPeopleReadThem) {
  EXPECT_EQ(limit_text(1e9), "1 000 000 000");
  EXPECT_EQ(limit_text(-1e12), "-1 000 000 000 000");
  EXPECT_EQ(limit_text(1e100), "1e100");
  EXPECT_EQ(limit_text(0.5), "0.5");
}

}  // namespace
}  // namespace linkwright::count_text_test
