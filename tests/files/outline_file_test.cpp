#include "linkwright/files/outline_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

std::string svg(std::string_view inside) { return "<svg>" + std::string(inside) + "</svg>"; }

Drawing read_svg(std::string_view inside) {
  const auto drawing = read_svg_outlines(svg(inside));
  EXPECT_TRUE(drawing.ok());
  return drawing.ok() ? *drawing : Drawing{{{{0, 1, Point(0, 1)}}}, {}};
}

TEST(OutlineFile, CornersAreDrawnUpwards) {
  const DrawnShape shape = read_svg(R"(<path d="M10 20h30v-10L10,10z"/>)").shapes.at(0);
  EXPECT_EQ(shape.corners, (std::vector<Point>{{10, -20}, {40, -20}, {40, -10}, {10, -10}}));
  EXPECT_TRUE(shape.closed);
  EXPECT_EQ(shape.width, 30);
}

TEST(OutlineFile, CurvesStayWithinAThousandthOfTheirSize) {
  const DrawnShape circle = read_svg(R"(<circle r="50"/>)").shapes.at(0);
  for (std::size_t i = 0; i < circle.corners.size(); ++i) {
    const Point middle = (circle.corners[i] + circle.corners[(i + 1) % circle.corners.size()]) / 2.0;
    EXPECT_NEAR(std::abs(middle), 50, 0.1);
  }
}

TEST(OutlineFile, AnOutlineIsPlacedAndHasNoMoreCornersThanABodyMay) {
  DrawnShape square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, true, false, 2, 2};
  const auto outline = body_outline(square, 10, {{1, 2}, radians(90)});
  EXPECT_EQ(outline, (std::vector<Point>{{1, 2}, {1, 22}, {-19, 22}, {-19, 2}}));
  DrawnShape wave{{}, true};
  for (int i = 0; i < 3000; ++i) wave.corners.push_back((100 + 10 * std::sin(i / 95.5)) * direction(i / 477.5));
  EXPECT_LE(body_outline(wave, 1, {}).size(), 200u);
}

TEST(OutlineFile, AShapeOfAnotherSizeIsBroughtToTheTasksAndOneFarAwayToTheOrigin) {
  const DrawnShape square{{{100, 0}, {102, 0}, {102, 2}, {100, 2}}, true, false, 2, 2};
  EXPECT_EQ(fit_outline(square, 1, 10).placed.origin, Point(-101, -1));
  EXPECT_FALSE(fit_outline(square, 1, 10).resized);
  EXPECT_EQ(fit_outline(square, 1, 1000).scale, 500);
}

TEST(OutlineFile, WhatCannotBeReadIsRefusedWithItsPlace) {
  EXPECT_EQ(read_dxf_outlines("0\nSECTION\n2\nENTITIES\nx\n").errors()[0].place, "line 5");
  EXPECT_EQ(read_svg_outlines("<svg>\n<g>\n</svg>").errors()[0].place, "line 3");
  EXPECT_EQ(read_svg_outlines(svg("")).errors()[0].code, "no_outline");
  EXPECT_EQ(read_svg_outlines(svg(R"(<g id="a"><use href="#a"/><use href="#a"/></g>)")).errors()[0].code,
            "drawing_of_too_much");
}

}  // namespace
}  // namespace linkwright
