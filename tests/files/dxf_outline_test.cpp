#include <algorithm>
#include <gmock/gmock.h>
#include <numbers>

#include "linkwright/core/angle.hpp"
#include "outline_support.hpp"

namespace linkwright {
namespace {

using namespace linkwright::testing;
using ::testing::Contains;

const std::vector<Point> plate = {{0, 0}, {80, 0}, {80, 20}, {0, 20}};

TEST(DxfOutline, HasTheCornersOfPolylinesNewAndOld) {
  EXPECT_EQ(dxf_shape(rectangle(0, 0, 80, 20)).corners, plate);
  std::string old = groups({{0, "POLYLINE"}, {66, 1}, {10, 0}, {20, 0}, {70, 1}});
  for (const Point p : plate) old += groups({{0, "VERTEX"}, {8, "0"}, {10, p.real()}, {20, p.imag()}});
  const DrawnShape shape = dxf_shape(old + groups({{0, "SEQEND"}}));
  EXPECT_EQ(shape.corners, plate);
  EXPECT_TRUE(shape.closed);
}

TEST(DxfOutline, BulgesAreArcsToEitherSide) {
  // 40 long between the centres of two half circles of radius 10.
  const DrawnShape slot = dxf_shape(polyline({{0, -10}, {40, -10, 1}, {40, 10}, {0, 10, 1}}));
  EXPECT_EQ(edges(slot), (Edges{-10, 50, -10, 10}));
  EXPECT_NEAR(area(slot.corners), 800 + 100 * std::numbers::pi, 5);
  for (const Point p : slot.corners) EXPECT_NEAR(p.real() > 40 ? std::abs(p - 40.0) : 10, 10, 1e-9);
  const DrawnShape notched = dxf_shape(polyline({{0, 0}, {40, 0, -0.5}, {40, 40}, {0, 40}}));
  EXPECT_EQ(edges(notched), (Edges{0, 40, 0, 40}));
  EXPECT_NEAR(area(notched.corners), 1600 - 279.6, 5);
}

TEST(DxfOutline, CirclesEllipsesAndArcsAreWithinAThousandthOfTheirSize) {
  const DrawnShape circle = dxf_shape(groups({{0, "CIRCLE"}, {10, 5}, {20, 6}, {40, 100}}));
  EXPECT_TRUE(circle.closed);
  for (std::size_t i = 0; i < circle.corners.size(); ++i) {
    const Point middle = (circle.corners[i] + circle.corners[(i + 1) % circle.corners.size()]) / 2.0;
    EXPECT_NEAR(std::abs(middle - Point(5, 6)), 100, 0.2);
  }
  const DrawnShape ellipse = dxf_shape(
      groups({{0, "ELLIPSE"}, {10, 0}, {20, 0}, {11, 0}, {21, 50}, {40, 0.4}, {41, 0}, {42, 2 * std::numbers::pi}}));
  EXPECT_EQ(edges(ellipse), (Edges{-20, 20, -50, 50}));
  EXPECT_NEAR(area(ellipse.corners), 1000 * std::numbers::pi, 20);
  const DrawnShape half = dxf_shape(arc(0, 10, 270, 90));
  EXPECT_EQ(edges(half), (Edges{0, 10, -10, 10}));
  EXPECT_FALSE(half.closed);
}

TEST(DxfOutline, NineControlPointsOfARationalSplineAreACircle) {
  std::string spline = groups({{0, "SPLINE"}, {70, 4}, {71, 2}, {72, 12}, {73, 9}});
  for (const double knot : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}) spline += groups({{40, knot}});
  for (int i = 0; i < 9; ++i) spline += groups({{41, i % 2 == 1 ? std::numbers::sqrt2 / 2 : 1}});
  for (const Point p : std::vector<Point>{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}})
    spline += groups({{10, 7 * p.real()}, {20, 7 * p.imag()}});
  const DrawnShape shape = dxf_shape(spline);
  for (const Point p : shape.corners) EXPECT_NEAR(std::abs(p), 7, 1e-9);
  EXPECT_TRUE(shape.closed);
  EXPECT_EQ(edges(shape), (Edges{-7, 7, -7, 7}));
}

TEST(DxfOutline, LinesAndArcsAreJoinedWhicheverWayTheyRun) {
  const DrawnShape slot =
      dxf_shape(line({40, 10}, {0, 10}) + line({0, -10}, {40, -10}) + arc(40, 10, -90, 90) + arc(0, 10, 90, 270));
  EXPECT_TRUE(slot.closed);
  EXPECT_EQ(edges(slot), (Edges{-10, 50, -10, 10}));
  const DrawnShape triangle = dxf_shape(line({0, 0}, {10, 0}) + line({5, 8}, {10, 0}) + line({5, 8}, {0, 0}));
  EXPECT_EQ(triangle.corners.size(), 3u);
}

TEST(DxfOutline, LoopsAreFoundBeyondPlacesWhereMoreThanTwoLinesMeetAndPolylinesThatMeetThereStayApart) {
  const std::string with_rib = line({0, 0}, {10, 0}) + line({10, 0}, {10, 8}) + line({10, 8}, {0, 8}) +
                               line({0, 8}, {0, 0}) + line({0, 0}, {10, 8});
  std::vector<Edges> closed;
  for (const DrawnShape& shape : drawing_in(read_dxf_outlines(dxf(with_rib))).shapes)
    if (shape.closed) closed.push_back(edges(shape));
  EXPECT_EQ(closed, (std::vector<Edges>{{0, 10, 0, 8}}));
  std::string three;
  for (const double y : {1, 2, 3}) three += polyline({{0, 0}, {5, y}, {10, 0}}, false);
  const auto shapes = drawing_in(read_dxf_outlines(dxf(three))).shapes;
  EXPECT_EQ(std::count_if(shapes.begin(), shapes.end(), [](const DrawnShape& shape) { return !shape.closed; }), 3);
}

TEST(DxfOutline, TheContourOfAFlatPatternStaysWholeWhereFoldLinesMeetItWhateverTheOrder) {
  const std::vector<Point> corners = {{19, 16}, {20, 17},  {150, 17}, {151, 16}, {150, 15},  {150, 0},
                                      {170, 0}, {170, 15}, {169, 16}, {170, 17}, {170, 104}, {0, 104},
                                      {0, 17},  {1, 16},   {0, 15},   {0, 0},    {20, 0},    {20, 15}};
  std::vector<std::string> lines = {line({1, 16}, {19, 16}), line({151, 16}, {169, 16})};
  for (std::size_t i = 0; i < corners.size(); ++i) lines.push_back(line(corners[i], corners[(i + 1) % corners.size()]));
  for (int turn = 0; turn < 3; ++turn) {
    std::string entities;
    for (const std::string& one : lines) entities += one;
    const DrawnShape shape = drawing_in(read_dxf_outlines(dxf(entities))).shapes[0];
    EXPECT_TRUE(shape.closed);
    EXPECT_EQ(edges(shape), (Edges{0, 170, 0, 104}));
    EXPECT_EQ(shape.corners.size(), corners.size());
    if (turn == 0)
      std::reverse(lines.begin(), lines.end());
    else
      std::rotate(lines.begin(), lines.begin() + 7, lines.end());
  }
}

std::string block(std::string_view name, Point base, std::string_view entities) {
  return groups({{0, "BLOCK"}, {2, name}, {10, base.real()}, {20, base.imag()}, {30, 0}}) + std::string(entities) +
         groups({{0, "ENDBLK"}});
}

TEST(DxfOutline, BlocksLieWhereTheyAreInserted) {
  const std::string blocks =
      section("BLOCKS", block("plate", {1, 1}, rectangle(1, 1, 4, 2)) +
                            block("outer", 0, groups({{0, "INSERT"}, {2, "plate"}, {10, 10}, {20, 0}, {50, 90}})));
  const auto inserted = [&](std::initializer_list<Group> how) {
    return read_dxf_outlines(dxf_of(blocks + section("ENTITIES", groups({{0, "INSERT"}}) + groups(how))));
  };
  EXPECT_EQ(edges(shape_in(inserted({{2, "plate"}, {10, 100}, {20, 50}}))), (Edges{100, 104, 50, 52}));
  EXPECT_EQ(edges(shape_in(inserted({{2, "plate"}, {10, 0}, {20, 0}, {41, 2}, {42, 3}, {50, 90}}))),
            (Edges{-6, 0, 0, 8}));
  EXPECT_EQ(edges(shape_in(inserted({{2, "outer"}, {10, 0}, {20, 5}}))), (Edges{8, 10, 5, 9}));
  EXPECT_EQ(edges(shape_in(inserted({{2, "plate"}, {10, 1}, {20, 0}, {230, -1}}))), (Edges{-5, -1, 0, 2}));
  std::vector<Edges> rows;
  for (const DrawnShape& shape :
       drawing_in(inserted({{2, "plate"}, {10, 0}, {20, 0}, {70, 3}, {71, 2}, {44, 10}, {45, 20}})).shapes)
    rows.push_back(edges(shape));
  EXPECT_EQ(rows.size(), 6u);
  EXPECT_THAT(rows, Contains(Edges{20, 24, 20, 22}));
}

TEST(DxfOutline, KnowsTheFilesUnit) {
  const auto read = read_dxf_outlines(
      dxf_of(section("HEADER", groups({{9, "$INSUNITS"}, {70, 1}})) + section("ENTITIES", rectangle(0, 0, 4, 2))));
  const std::optional<double> unit_mm = drawing_in(read).unit_mm;
  EXPECT_EQ(drawing_scale(unit_mm, "mm"), 25.4);
  EXPECT_EQ(drawing_scale(unit_mm, "Inches"), 1);
  EXPECT_EQ(drawing_scale(unit_mm, "furlong"), 1);
  EXPECT_EQ(drawing_scale({}, "mm"), 1);
}

TEST(DxfOutline, LeavesOutWhatIsHiddenOrOnPaperOnly) {
  const std::string hidden = rectangle(0, 0, 900, 800) + groups({{60, 1}}),
                    on_paper = rectangle(0, 0, 700, 600) + groups({{67, 1}});
  EXPECT_EQ(edges(dxf_shape(hidden + on_paper + rectangle(0, 0, 4, 2))), (Edges{0, 4, 0, 2}));
}

TEST(DxfOutline, WhatIsNoneIsRefusedWithTheReason) {
  EXPECT_EQ(code_of(read_dxf_outlines("nonsense")), "not_dxf");
  EXPECT_EQ(code_of(read_dxf_outlines("")), "not_dxf");
  EXPECT_EQ(code_of(read_dxf_outlines("AutoCAD Binary DXF\r\n\x1a")), "binary_dxf");
  EXPECT_EQ(code_of(read_dxf_outlines("0\nSECTION\n2\nENTITIES\n")), "dxf_cut_off");
  const auto broken = read_dxf_outlines("0\nSECTION\n2\nENTITIES\nx\n");
  EXPECT_EQ(code_of(broken), "dxf_group");
  EXPECT_EQ(broken.errors()[0].place, "line 5");
  for (const std::string& nothing :
       {groups({{0, "TEXT"}, {1, "a"}}), line(0, 1), polyline({{NAN, 0}, {1, NAN}, {2, 2}}), groups({{0, "CIRCLE"}}),
        groups({{0, "CIRCLE"}, {10, "x"}, {20, 0}, {40, "Infinity"}}),
        groups({{0, "SPLINE"}, {71, 3}, {40, 1}, {40, 0}, {10, 1}, {20, 1}}), rectangle(0, 0, 1e300, 1e300)})
    EXPECT_EQ(code_of(read_dxf_outlines(dxf(nothing))), "no_outline") << nothing;
}

TEST(DxfOutline, WhatNeverEndsIsRefused) {
  const auto inserted = [](std::string_view blocks, std::initializer_list<Group> how) {
    return code_of(read_dxf_outlines(
        dxf_of(section("BLOCKS", blocks) + section("ENTITIES", groups({{0, "INSERT"}}) + groups(how)))));
  };
  std::string doubled = block("b0", 0, rectangle(0, 0, 4, 2));
  for (int i = 1; i < 30; ++i) {
    const std::string before = fmt::format("b{}", i - 1);
    doubled +=
        block(fmt::format("b{}", i), 0, groups({{0, "INSERT"}, {2, before}, {0, "INSERT"}, {2, before}, {10, 5}}));
  }
  EXPECT_EQ(inserted(doubled, {{2, "b15"}}), "drawing_of_too_much");
  EXPECT_EQ(inserted(doubled, {{2, "b29"}}), "drawing_of_too_much");
  EXPECT_EQ(inserted(block("b", 0, groups({{0, "INSERT"}, {2, "b"}})), {{2, "b"}}), "drawing_of_too_much");
  EXPECT_EQ(inserted(block("b", 0, ""), {{2, "b"}, {70, 1e9}, {71, 1e9}}), "drawing_of_too_much");
}

TEST(DxfOutline, WhatIsLargeIsReadOrRefusedAtOnce) {
  std::string circles, star;
  for (int i = 0; i < 100'000; ++i) circles += groups({{0, "CIRCLE"}, {10, double(i)}, {20, 0}, {40, 9}});
  for (int i = 0; i < 40'000; ++i) star += line(0, {i + 1.0, 1});
  EXPECT_EQ(code_of(read_dxf_outlines(dxf(circles))), "drawing_of_too_much");
  EXPECT_EQ(code_of(read_dxf_outlines(dxf(star))), "no_outline");
}

}  // namespace
}  // namespace linkwright
