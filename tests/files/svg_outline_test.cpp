#include <cmath>
#include <numbers>

#include "outline_support.hpp"

namespace linkwright {
namespace {

using namespace linkwright::testing;

TEST(SvgOutline, HasTheCornersOfStraightPathsUpwards) {
  const DrawnShape shape = svg_shape(R"(<path d="M10 20h30v-10L10,10z"/>)");
  EXPECT_EQ(shape.corners, (std::vector<Point>{{10, -20}, {40, -20}, {40, -10}, {10, -10}}));
  EXPECT_TRUE(shape.closed);
  EXPECT_EQ(shape.width, 30);
  const DrawnShape relative = svg_shape(R"(<path d="m1e1,0 5,5 -5.5.5"/>)");
  EXPECT_EQ(relative.corners.at(2), Point(9.5, -5.5));
  EXPECT_FALSE(relative.closed);
}

TEST(SvgOutline, GroupsInnerFramesAndUsedPartsLieWhereTheyAreDrawn) {
  const std::string plate = R"(<rect id="plate" x="1" y="2" width="4" height="2"/>)";
  const auto placed = [&](std::string_view before, std::string_view after) {
    return edges(svg_shape(std::string(before) + plate + std::string(after)));
  };
  EXPECT_EQ(placed(R"svg(<g transform="translate(10 0)"><g transform="scale(2)">)svg", "</g></g>"),
            (Edges{12, 20, -8, -4}));
  EXPECT_EQ(placed(R"svg(<g transform="rotate(90)"><g transform="translate(1,1)">)svg", "</g></g>"),
            (Edges{-5, -3, -6, -2}));
  EXPECT_EQ(placed(R"(<svg x="100" width="50" height="50" viewBox="0 0 10 10">)", "</svg>"),
            (Edges{105, 125, -20, -10}));
  for (const std::string_view href : {"href", "xlink:href"})
    EXPECT_EQ(placed("<defs>", fmt::format(R"svg(</defs><use {}="#plate" x="3" transform="scale(10 1)"/>)svg", href)),
              (Edges{40, 80, -4, -2}));
  EXPECT_EQ(placed(R"(<symbol id="s">)", R"(</symbol><use href="#s" x="3"/>)"), (Edges{4, 8, -4, -2}));
}

TEST(SvgOutline, CurvesAreWithinAThousandthOfTheirSize) {
  const DrawnShape round = svg_shape(R"(<rect width="40" height="20" rx="10"/>)");
  EXPECT_NEAR(area(round.corners), 40 * 20 - (4 - std::numbers::pi) * 100, 5);
  EXPECT_EQ(edges(round), (Edges{0, 40, -20, 0}));
  EXPECT_EQ(edges(svg_shape(R"svg(<circle cx="3" cy="4" r="50" transform="scale(2 1)"/>)svg")),
            (Edges{-94, 106, -54, 46}));
  EXPECT_EQ(edges(svg_shape(R"(<path d="M0 0C0 40 60 40 60 0S120 -40 120 0z"/>)")), (Edges{0, 120, -30, 30}));
  EXPECT_EQ(edges(svg_shape(R"(<path d="M0 0A30 20 0 0 1 60 0Z"/>)")), (Edges{0, 60, 0, 20}));
  const DrawnShape circle = svg_shape(R"(<circle r="50"/>)");
  for (std::size_t i = 0; i < circle.corners.size(); ++i) {
    const Point middle = (circle.corners[i] + circle.corners[(i + 1) % circle.corners.size()]) / 2.0;
    EXPECT_NEAR(std::abs(middle), 50, 0.1);
  }
}

TEST(SvgOutline, HasEveryPartOfAPathAndWhatIsDrawnOnly) {
  std::vector<Edges> ring;
  for (const DrawnShape& shape :
       drawing_in(read_svg_outlines(svg(R"(<path d="M0 0h40v40h-40zM10 10v20h20v-20z"/>)"))).shapes)
    ring.push_back(edges(shape));
  EXPECT_EQ(ring, (std::vector<Edges>{{0, 40, -40, 0}, {10, 30, -30, -10}}));
  EXPECT_EQ(edges(svg_shape(R"(<clipPath><rect width="9" height="9"/></clipPath>
    <g display="none"><rect width="8" height="8"/></g><rect style="fill:red;display:none" width="7" height="7"/>
    <polygon points="0,0 4,0 4,2"/>)")),
            (Edges{0, 4, -2, 0}));
}

TEST(SvgOutline, KnowsMillimetresAndInches) {
  const auto unit_mm = [](std::string_view attributes) {
    return drawing_in(read_svg_outlines(svg(R"(<rect width="4" height="2"/>)", attributes))).unit_mm;
  };
  EXPECT_DOUBLE_EQ(unit_mm(R"(width="210mm" height="297mm" viewBox="0 0 2100 2970")").value_or(0), 0.1);
  EXPECT_DOUBLE_EQ(unit_mm(R"(width="8.5in" viewBox="0 0 850 1100")").value_or(0), 0.254);
  EXPECT_DOUBLE_EQ(unit_mm(R"(width="100mm")").value_or(0), 25.4 / 96);
  EXPECT_EQ(unit_mm(R"(width="100" viewBox="0 0 10 10")"), std::nullopt);
}

TEST(SvgOutline, WhatIsNoneIsRefusedWithTheReason) {
  const auto broken = read_svg_outlines("<svg>\n<g>\n</svg>");
  EXPECT_EQ(code_of(broken), "not_xml");
  EXPECT_EQ(broken.errors()[0].place, "line 3");
  EXPECT_EQ(code_of(read_svg_outlines(XmlElements{})), "not_xml");
  EXPECT_EQ(code_of(read_svg_outlines("<html><body/></html>")), "not_svg");
  for (const std::string_view nothing :
       {"", "<text>hello</text>", R"(<path d="nonsense"/><rect width="-4" height="1e999"/>)"})
    EXPECT_EQ(code_of(read_svg_outlines(svg(nothing))), "no_outline");
}

TEST(SvgOutline, WhatNeverEndsOrIsTooMuchIsRefused) {
  EXPECT_EQ(code_of(read_svg_outlines(svg(R"(<g id="a"><use href="#a"/><use href="#a"/></g>)"))),
            "drawing_of_too_much");
  std::string nested, zigzag = R"(<path d="M0 0)";
  for (int i = 0; i < 100'000; ++i) nested += "<g>";
  for (int i = 0; i < 100'000; ++i) nested += "</g>";
  EXPECT_EQ(code_of(read_svg_outlines(svg(nested))), "drawing_of_too_much");
  for (int i = 0; i < 110'000; ++i) {
    zigzag += fmt::format("L{} {}", i % 2, i);
    if (i != 50'000) continue;
    EXPECT_LE(body_outline(svg_shape(zigzag + R"(z"/>)"), 1, {}).size(), 200u);
  }
  EXPECT_EQ(code_of(read_svg_outlines(svg(zigzag + R"(z"/>)"))), "drawing_of_too_much");
}

}  // namespace
}  // namespace linkwright
