#include "linkwright/mechanism/four_bar.hpp"

#include <gtest/gtest.h>

namespace linkwright::four_bar_test {
namespace {

// Pivots on a grid of 3-4-5 triangles.
constexpr Point input_fixed{0, 0}, input_moving{3, 4}, output_fixed{12, 0}, output_moving{12, 4};

TEST(FourBar, HasTheLengthsBetweenItsPivots) {
  const LinkLengths l = FourBar{input_fixed, input_moving, output_fixed, output_moving}.lengths();
  EXPECT_DOUBLE_EQ(l.ground, 12);
  EXPECT_DOUBLE_EQ(l.input, 5);
  EXPECT_DOUBLE_EQ(l.coupler, 9);
  EXPECT_DOUBLE_EQ(l.output, 4);
  EXPECT_DOUBLE_EQ(l.perimeter(), 30);
  EXPECT_DOUBLE_EQ(l.longest(), 12);
  EXPECT_DOUBLE_EQ(l.shortest(), 4);
}

TEST(FourBar, DrivenFromTheOtherSideHasInputAndOutputSwapped) {
  const FourBar four_bar{input_fixed, input_moving, output_fixed, output_moving};
  const LinkLengths l = four_bar.lengths(), s = four_bar.swapped().lengths();
  EXPECT_EQ(s.input, l.output);
  EXPECT_EQ(s.output, l.input);
  EXPECT_EQ(s.ground, l.ground);
  EXPECT_EQ(s.coupler, l.coupler);
  EXPECT_EQ(l.swapped().input, s.input);
  EXPECT_EQ(four_bar.swapped().swapped().input_moving, four_bar.input_moving);
}

TEST(FourBar, IsAsFarFromAnotherAsTheFarthestPivotWhicheverGroundedLinkIsNamedFirst) {
  const FourBar four_bar{input_fixed, input_moving, output_fixed, output_moving};
  FourBar other = four_bar;
  other.output_moving += Point{3, -4};
  EXPECT_DOUBLE_EQ(farthest_pivot(four_bar, other), 5);
  EXPECT_DOUBLE_EQ(farthest_pivot(four_bar, other.swapped()), 5);
  EXPECT_EQ(farthest_pivot(four_bar, four_bar.swapped()), 0);
}

TEST(Dyad, IsASideLinkOrASliderByWhichPivotIsAtInfinity) {
  const Dyad grounded_link{Homogeneous::of({0, 0}), Homogeneous::of({1, 2}), 0.25};
  const Dyad on_a_fixed_line{Homogeneous::at_infinity({0, 1}), Homogeneous::of({1, 2}), 0.5};
  const Dyad with_a_moving_guide{Homogeneous::of({0, 0}), Homogeneous::at_infinity({1, 0}), 0.75};
  EXPECT_TRUE(finite_point(grounded_link.center) && finite_point(grounded_link.circle));
  EXPECT_FALSE(finite_point(on_a_fixed_line.center));
  EXPECT_TRUE(finite_point(on_a_fixed_line.circle));
  EXPECT_FALSE(finite_point(with_a_moving_guide.circle));
}

TEST(TracingFourBar, TheArmsOfItsPointCountAsLinks) {
  const FourBar bars{{0, 0}, {0, 1}, {3, 0}, {3, 2}};
  EXPECT_DOUBLE_EQ((TracingFourBar{bars, {1.5, 1.5}}.longest()), bars.lengths().longest());
  EXPECT_DOUBLE_EQ((TracingFourBar{bars, {0, 9}}.longest()), 8);
  EXPECT_DOUBLE_EQ((TracingFourBar{bars, {3, -7}}.longest()), 9);
}

TEST(TracingFourBar, SwappedItTracesTheSamePoint) {
  const TracingFourBar linkage{{{0, 0}, {0, 1}, {3, 0}, {3, 2}}, {1, 5}};
  EXPECT_EQ(linkage.swapped().point, linkage.point);
  EXPECT_EQ(linkage.swapped().bars.input_fixed, linkage.bars.output_fixed);
  EXPECT_DOUBLE_EQ(linkage.swapped().longest(), linkage.longest());
}

TEST(TracingFourBar, MovedItsCouplerKeepsItsShape) {
  const TracingFourBar linkage{{{0, 0}, {0, 1}, {3, 0}, {3, 1}}, {1, 5}};
  const TracingFourBar moved = linkage.moved_to({{0, 0}, {0.6, 0.8}, {3, 0}, {3.6, 0.8}});
  EXPECT_NEAR(std::abs(moved.point - Point(1.6, 4.8)), 0, 1e-15) << "a parallelogram shifts its coupler";
  EXPECT_EQ(moved.bars.input_moving, Point(0.6, 0.8));
}

}  // namespace
}  // namespace linkwright::four_bar_test
