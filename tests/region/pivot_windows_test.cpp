#include "linkwright/region/pivot_windows.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::pivot_windows_test {
namespace {

const Box box{0, 4, 1, 3};
const Cone cone{{0, 0, 2}, radians(30)};

TEST(PivotWindows, HoldHingesAndTheirBorders) {
  EXPECT_TRUE(contains(box, {4, 1, 0}));
  EXPECT_TRUE(contains(box, {4 + 1e-12, 2, 0})) << "computed to lie on the border";
  EXPECT_FALSE(contains(box, {4.001, 2, 0}));
  EXPECT_TRUE(contains(Box{0, 4, 2, 2}, {1, 2, 0})) << "without height";
  EXPECT_TRUE(contains(cone, {0, 0.5, -1})) << "a line has no sense";
  EXPECT_FALSE(contains(cone, {0, 0.6, 1}));
}

TEST(PivotWindows, TellHowFarAHingeLiesOutside) {
  EXPECT_EQ(distance_to(box, {2, 2, 0}), 0);
  EXPECT_DOUBLE_EQ(distance_to(box, {7, -3, 0}), 5);
  EXPECT_NEAR(distance_to(cone, {0, 1, 0}), radians(60), 1e-15);
}

TEST(PivotWindows, BorderValuesChangeSignAtEachSide) {
  const auto sign_changes = [](const PivotWindow& window, Vector3 inside, Vector3 outside) {
    std::vector<double> in, out;
    append_border_values(window, inside, in);
    append_border_values(window, outside, out);
    int changes = 0;
    for (std::size_t i = 0; i < in.size(); ++i) changes += (in[i] < 0) != (out[i] < 0);
    return changes;
  };
  for (const Vector3 outside : {Vector3{-1, 2, 0}, Vector3{5, 2, 0}, Vector3{2, 0, 0}, Vector3{2, 4, 0}})
    EXPECT_EQ(sign_changes(box, {2, 2, 0}, outside), 1);
  EXPECT_EQ(sign_changes(cone, {0, 0, 1}, {0, 1, 0}), 1);
}

TEST(PivotWindows, AreThoseOfTheClass) {
  Requirements wanted;
  wanted.ground_pivots_within = box;
  wanted.moving_axes_within = cone;
  EXPECT_EQ(windows_of(wanted, planar_linkages), (PivotWindows{box, std::nullopt}));
  EXPECT_EQ(windows_of(wanted, spherical_linkages), (PivotWindows{std::nullopt, cone}));
  EXPECT_FALSE(windows_of({}, planar_linkages).any());
}

TEST(PivotWindows, HoldALinkWithBothItsHinges) {
  const PivotWindows windows{box, Box{10, 11, 0, 1}};
  EXPECT_TRUE(windows.hold({Vector3{1, 2, 0}, Vector3{10.5, 0.5, 0}}));
  EXPECT_FALSE(windows.hold({Vector3{1, 2, 0}, Vector3{1, 2, 0}}));
  EXPECT_FALSE(windows.hold({Vector3{1, 2, 0}, std::nullopt})) << "at infinity is nowhere";
}

// A circle through a thin window: the stretches that lie in it, and where it only touches.
TEST(PivotWindows, StretchesOfACircle) {
  const MapAxis axis{AxisQuantity::curve_coordinate, {{"circle", 0, 1}}};
  const auto on_circle = [](double t) {
    return GroundedLinkPivots{Vector3{5 * std::cos(two_pi * t), 5 * std::sin(two_pi * t), 0}, Vector3{0, 0, 0}};
  };
  std::vector<double> knots;
  for (int i = 0; i < 40; ++i) knots.push_back(i / 40.0);
  const auto arcs = [&](Box window) { return arcs_within(axis, knots, {window, std::nullopt}, on_circle); };
  const auto thin = arcs({0, 6, 3, 3.001});
  ASSERT_EQ(thin.size(), 1u);
  EXPECT_NEAR(thin[0].from, std::asin(3 / 5.0) / two_pi, 1e-14);
  EXPECT_NEAR(thin[0].to, std::asin(3.001 / 5.0) / two_pi, 1e-14);
  const auto without_height = arcs({-6, 6, 3, 3});
  ASSERT_EQ(without_height.size(), 2u);
  EXPECT_NEAR(without_height[1].from, 0.5 - std::asin(3 / 5.0) / two_pi, 1e-14);
  const auto touched = arcs({-1, 1, 5, 6});
  ASSERT_EQ(touched.size(), 1u);
  EXPECT_NEAR(touched[0].from, 0.25, 1e-6);
  EXPECT_TRUE(arcs({-1, 1, 5.01, 6}).empty());
}

}  // namespace
}  // namespace linkwright::pivot_windows_test
