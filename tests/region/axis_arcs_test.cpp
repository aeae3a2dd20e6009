#include "linkwright/region/axis_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::axis_arcs_test {
namespace {

const MapAxis two_branches{AxisQuantity::curve_coordinate, {{"odd", 0, 1}, {"oval", 1, 2}}};

std::vector<double> knots(int count) {
  std::vector<double> found;
  for (int branch = 0; branch < 2; ++branch)
    for (int i = 0; i < count; ++i) found.push_back(branch + static_cast<double>(i) / count);
  return found;
}

BorderValues values_of(double (*function)(double)) {
  return [function](double x) { return std::optional(std::vector<double>{function(x)}); };
}

TEST(AxisArcs, EndAtTheBordersAndKeepToTheirBranch) {
  const auto arcs =
      arcs_where(two_branches, {0.75, 0.25, 0.5, 1.5}, [](double x) { return (x >= 0.25 && x <= 0.75) || x >= 1.5; });
  EXPECT_EQ(arcs, (std::vector<AxisArc>{{0.25, 0.75}, {1.5, std::nextafter(2.0, 0.0)}}));
}

TEST(AxisArcs, APlaceThatOnlyTouchesIsAnArcWithoutLength) {
  const auto arcs = arcs_where(two_branches, {0.5, 1.25}, [](double x) { return x == 0.5 || x == 1.25; });
  EXPECT_EQ(arcs, (std::vector<AxisArc>{{0.5, 0.5}, {1.25, 1.25}}));
  EXPECT_EQ(samples_over(arcs[0], 9), std::vector<double>{0.5});
}

TEST(AxisArcs, NeedNoBorders) {
  EXPECT_TRUE(arcs_where(two_branches, {}, [](double) { return false; }).empty());
  EXPECT_EQ(arcs_where(two_branches, {}, [](double) { return true; }).size(), 2u) << "one to each branch";
}

TEST(AxisArcs, BordersAreMetToTheLastDigit) {
  const auto borders = borders_between(knots(16), values_of([](double x) { return std::cos(pi * x) - 0.3; }));
  ASSERT_EQ(borders.size(), 2u);
  EXPECT_NEAR(borders[0], std::acos(0.3) / pi, 1e-15);
  EXPECT_NEAR(borders[1], 2 - std::acos(0.3) / pi, 1e-15);
}

TEST(AxisArcs, TwoBordersBetweenTwoKnotsAreBothFound) {
  // 1e-4 wide, where knots are 0.06 apart.
  const auto borders = borders_between(knots(16), values_of([](double x) { return (x - 0.71) * (x - 0.71) - 1e-8; }));
  EXPECT_TRUE(std::any_of(borders.begin(), borders.end(), [](double x) { return std::abs(x - 0.7099) < 1e-9; }));
  EXPECT_TRUE(std::any_of(borders.begin(), borders.end(), [](double x) { return std::abs(x - 0.7101) < 1e-9; }));
}

TEST(AxisArcs, WhereValuesEndIsABorder) {
  const auto borders = borders_between(
      knots(16), [](double x) { return x < 0.31 ? std::optional(std::vector<double>{1.0}) : std::nullopt; });
  ASSERT_FALSE(borders.empty());
  EXPECT_NEAR(borders.front(), 0.31, 1e-12);
}

TEST(AxisArcs, AreClipped) {
  EXPECT_EQ(clipped({{0, 0.2}, {0.4, 0.6}, {0.8, 0.9}}, {{0.1, 0.5}, {0.85, 1}}),
            (std::vector<AxisArc>{{0.1, 0.2}, {0.4, 0.5}, {0.85, 0.9}}));
}

TEST(AxisArcs, OfAnAxisThatClosesMayReachBeyondItsEnds) {
  using Arcs = std::vector<AxisArc>;
  const MapAxis closed{AxisQuantity::curve_coordinate, {{"closed", 0, 1}, {"odd", 1, 2}}};
  EXPECT_EQ(arcs_of(closed, {0.25, 0.5}), (Arcs{{0.25, 0.5}}));
  EXPECT_EQ(arcs_of(closed, {-0.5, -0.25}), (Arcs{{1.5, 1.75}}));
  EXPECT_EQ(arcs_of(closed, {-0.5, 0.25}), (Arcs{{0, 0.25}, {1.5, 2}}));
  EXPECT_EQ(arcs_of(closed, {1.5, 2.25}), (Arcs{{0, 0.25}, {1.5, 2}}));
  EXPECT_EQ(arcs_of(closed, {-1, 3}), (Arcs{{0, 2}}));
  const MapAxis open{AxisQuantity::center_x, {{"range", 0, 1}}};
  EXPECT_EQ(arcs_of(open, {-0.5, 0.25}), (Arcs{{-0.5, 0.25}}));
  const MapAxis discrete{AxisQuantity::burmester_point, {{"point", 0, 1}, {"point", 1, 2}}};
  EXPECT_EQ(arcs_of(discrete, {0.25, 0.5}), (Arcs{{0, 2}}));
}

TEST(AxisArcs, AreSampledWithoutTheirEnds) {
  EXPECT_EQ(samples_over({1, 2}, 4), (std::vector<double>{1.125, 1.375, 1.625, 1.875}));
}

}  // namespace
}  // namespace linkwright::axis_arcs_test
