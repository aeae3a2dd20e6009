#include "linkwright/mechanism/four_bar.hpp"

#include <gtest/gtest.h>

namespace linkwright::four_bar_test {
namespace {

// Pivots on a grid of 3-4-5 triangles.
constexpr Point input_center{0, 0}, input_circle{3, 4}, output_center{12, 0}, output_circle{12, 4};

TEST(FourBar, HasTheLengthsBetweenItsPivots) {
  const LinkLengths l = FourBar{input_center, input_circle, output_center, output_circle}.lengths();
  EXPECT_DOUBLE_EQ(l.ground, 12);
  EXPECT_DOUBLE_EQ(l.input, 5);
  EXPECT_DOUBLE_EQ(l.coupler, 9);
  EXPECT_DOUBLE_EQ(l.output, 4);
  EXPECT_DOUBLE_EQ(l.perimeter(), 30);
  EXPECT_DOUBLE_EQ(l.longest(), 12);
  EXPECT_DOUBLE_EQ(l.shortest(), 4);
}

TEST(FourBar, DrivenFromTheOtherSideHasInputAndOutputSwapped) {
  const FourBar four_bar{input_center, input_circle, output_center, output_circle};
  const LinkLengths l = four_bar.lengths(), s = four_bar.swapped().lengths();
  EXPECT_EQ(s.input, l.output);
  EXPECT_EQ(s.output, l.input);
  EXPECT_EQ(s.ground, l.ground);
  EXPECT_EQ(s.coupler, l.coupler);
  EXPECT_EQ(l.swapped().input, s.input);
  EXPECT_EQ(four_bar.swapped().swapped().input_circle, four_bar.input_circle);
}

TEST(FourBar, IsAsFarFromAnotherAsTheFarthestPivotWhicheverGroundedLinkIsNamedFirst) {
  const FourBar four_bar{input_center, input_circle, output_center, output_circle};
  FourBar other = four_bar;
  other.output_circle += Point{3, -4};
  EXPECT_DOUBLE_EQ(farthest_pivot(four_bar, other), 5);
  EXPECT_DOUBLE_EQ(farthest_pivot(four_bar, other.swapped()), 5);
  EXPECT_EQ(farthest_pivot(four_bar, four_bar.swapped()), 0);
}

}  // namespace
}  // namespace linkwright::four_bar_test
