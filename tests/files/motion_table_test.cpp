#include "linkwright/files/motion_table.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright::motion_table_test {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

TEST(MotionTable, IsALineARowAndNothingWhereNothingIsDefined) {
  const MotionTable table{{"turn_deg", "rate", "position"}, {0, 0.1, 1, 1.5, undefined, undefined}};
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(csv_text(table), "turn_deg,rate,position\n0,0.1,1\n1.5,,\n");
}

TEST(MotionTable, WithoutRowsIsItsHeader) {
  EXPECT_EQ(csv_text({{"x", "y"}, {}}), "x,y\n");
  EXPECT_EQ(MotionTable{}.rows(), 0u);
}

}  // namespace
}  // namespace linkwright::motion_table_test
