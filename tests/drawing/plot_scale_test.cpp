#include "drawing/plot_scale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace linkwright::plot_scale_test {
namespace {

using ::testing::HasSubstr;

constexpr PixelBox box{100, 50, 200, 80};

TEST(PlotScale, LaysPlacesAcrossAndValuesUpwards) {
  PlotScale scale(box, -1, 3);
  scale.hold(2);
  scale.hold(6);
  EXPECT_DOUBLE_EQ(scale.x(0), 150);
  EXPECT_DOUBLE_EQ(scale.y(2), 130);
  EXPECT_DOUBLE_EQ(scale.y(6), 50);
  EXPECT_EQ(scale.at(3, 4), Point(300, 90));
}

TEST(PlotScale, WidenedLeavesRoomOnBothSidesEvenOfOneValue) {
  PlotScale scale(box, 0, 1);
  scale.hold(5);
  scale.widen();
  EXPECT_LT(scale.low(), 5);
  EXPECT_GT(scale.high(), 5);
  EXPECT_NEAR(scale.y(5), 90, 1e-1);
}

TEST(PlotScale, HasRoundNumbersAndTheTitle) {
  PlotScale scale(box, 0, 10);
  scale.hold(-0.002);
  scale.hold(0.002);
  SvgCanvas svg(400, 300, "");
  draw_plot_axes(svg, scale, {"Way", "#000000"});
  for (const char* text : {">Way</text>", ">0</text>", ">5</text>", ">-0.002</text>", ">0.002</text>"})
    EXPECT_THAT(svg.file(), HasSubstr(text));
}

}  // namespace
}  // namespace linkwright::plot_scale_test
