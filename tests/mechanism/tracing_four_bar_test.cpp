#include "linkwright/mechanism/tracing_four_bar.hpp"

#include <gtest/gtest.h>

namespace linkwright::tracing_four_bar_test {
namespace {

TEST(TracingFourBar, TheArmsOfItsPointCountAsLinks) {
  const FourBar bars{{0, 0}, {0, 1}, {3, 0}, {3, 2}};
  EXPECT_DOUBLE_EQ((TracingFourBar{bars, {1.5, 1.5}}.longest()), bars.lengths().longest());
  EXPECT_DOUBLE_EQ((TracingFourBar{bars, {0, 9}}.longest()), 8);
  EXPECT_DOUBLE_EQ((TracingFourBar{bars, {3, -7}}.longest()), 9);
}

TEST(TracingFourBar, SwappedItTracesTheSamePoint) {
  const TracingFourBar linkage{{{0, 0}, {0, 1}, {3, 0}, {3, 2}}, {1, 5}};
  EXPECT_EQ(linkage.swapped().point, linkage.point);
  EXPECT_EQ(linkage.swapped().bars.input_center, linkage.bars.output_center);
  EXPECT_DOUBLE_EQ(linkage.swapped().longest(), linkage.longest());
}

TEST(TracingFourBar, MovedItsCouplerKeepsItsShape) {
  const TracingFourBar linkage{{{0, 0}, {0, 1}, {3, 0}, {3, 1}}, {1, 5}};
  const TracingFourBar moved = linkage.moved_to({{0, 0}, {0.6, 0.8}, {3, 0}, {3.6, 0.8}});
  EXPECT_NEAR(std::abs(moved.point - Point(1.6, 4.8)), 0, 1e-15) << "a parallelogram shifts its coupler";
  EXPECT_EQ(moved.bars.input_circle, Point(0.6, 0.8));
}

}  // namespace
}  // namespace linkwright::tracing_four_bar_test
