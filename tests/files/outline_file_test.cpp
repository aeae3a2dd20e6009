#include "linkwright/files/outline_file.hpp"

#include <gmock/gmock.h>
#include <tuple>

#include "linkwright/core/angle.hpp"
#include "outline_support.hpp"

namespace linkwright {
namespace {

using namespace linkwright::testing;

using Told = std::tuple<double, double, bool, bool>;
std::vector<Told> told(const Drawing& drawing) {
  std::vector<Told> list;
  for (const DrawnShape& shape : drawing.shapes)
    list.emplace_back(std::round(shape.width), std::round(shape.height), shape.frame, shape.closed);
  return list;
}

TEST(OutlineFile, PartsComeBeforeOpenChainsBeforeTheFrameOfTheSheetAndItsBorder) {
  const std::string sheet = rectangle(0, 0, 420, 297) + rectangle(20, 10, 390, 277),
                    part = rectangle(100, 100, 80, 50) + groups({{0, "CIRCLE"}, {10, 120}, {20, 120}, {40, 5}}),
                    chain = line({200, 20}, {300, 20}) + line({300, 20}, {300, 90});
  EXPECT_EQ(told(drawing_in(read_dxf_outlines(dxf(sheet + chain + part)))),
            (std::vector<Told>{{80, 50, false, true},
                               {10, 10, false, true},
                               {100, 70, false, false},
                               {420, 297, true, true},
                               {390, 277, true, true}}));
}

TEST(OutlineFile, APlateWithHolesIsAPartAndTheEdgeOfAnSvgsSheetAFrame) {
  const std::string plate = rectangle(0, 0, 80, 20) + groups({{0, "CIRCLE"}, {10, 10}, {20, 10}, {40, 3}});
  for (const DrawnShape& shape : drawing_in(read_dxf_outlines(dxf(plate))).shapes) EXPECT_FALSE(shape.frame);
  EXPECT_FALSE(dxf_shape(rectangle(0, 0, 297, 210)).frame) << "a lone rectangle";
  const std::string sheet =
      svg(R"(<rect x="5" y="5" width="990" height="490"/><polygon points="100,100 300,100 200,200"/>)",
          R"(viewBox="0 0 1000 500")");
  EXPECT_EQ(told(drawing_in(read_svg_outlines(sheet))),
            (std::vector<Told>{{200, 100, false, true}, {990, 490, true, true}}));
}

TEST(OutlineFile, WhatIsDrawnTwiceIsThereOnce) {
  EXPECT_EQ(edges(dxf_shape(rectangle(0, 0, 8, 2) + rectangle(0, 0, 8, 2))), (Edges{0, 8, 0, 2}));
}

TEST(OutlineFile, AnOutlineIsPlacedAndHasNoMoreCornersThanABodyMay) {
  DrawnShape square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, true, false, 2, 2};
  const auto outline = body_outline(square, 10, {{1, 2}, radians(90)});
  EXPECT_EQ(outline, (std::vector<Point>{{1, 2}, {1, 22}, {-19, 22}, {-19, 2}}));
  DrawnShape wave{{}, true};
  for (int i = 0; i < 3000; ++i) wave.corners.push_back((100 + 10 * std::sin(i / 95.5)) * direction(i / 477.5));
  const auto corners = body_outline(wave, 1, {});
  EXPECT_LE(corners.size(), 200u);
  EXPECT_NEAR(area(corners) / area(wave.corners), 1, 0.002);
}

TEST(OutlineFile, AShapeOfAnotherSizeIsBroughtToTheTasksAndOneFarAwayToTheOrigin) {
  const DrawnShape square{{{100, 0}, {102, 0}, {102, 2}, {100, 2}}, true, false, 2, 2};
  EXPECT_EQ(fit_outline(square, 1, 10).placed.origin, Point(-101, -1));
  EXPECT_FALSE(fit_outline(square, 1, 10).resized);
  EXPECT_EQ(fit_outline(square, 1, 1000).scale, 500);
  const DrawnShape at_origin{{{0, 0}, {80, 0}, {80, 20}, {0, 20}}, true, false, 80, 20};
  EXPECT_EQ(fit_outline(at_origin, 1, 100).placed.origin, Point(0, 0));
}

}  // namespace
}  // namespace linkwright
