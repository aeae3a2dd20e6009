#include "drawing/plane_window.hpp"

#include <array>
#include <gtest/gtest.h>
#include <random>

namespace linkwright::plane_window_test {
namespace {

constexpr PixelBox box{100, 50, 400, 300};

TEST(PlaneWindow, ShowsAllPointsWithinTheMargin) {
  const std::array<Point, 3> points = {Point{-3, 7}, Point{5, 8}, Point{0, 20}};
  const PlaneWindow window(box, points, 30);
  for (const Point p : points) {
    const Point px = window.to_px(p);
    EXPECT_GE(px.real(), box.left + 30 - 1e-9);
    EXPECT_LE(px.real(), box.right() - 30 + 1e-9);
    EXPECT_GE(px.imag(), box.top + 30 - 1e-9);
    EXPECT_LE(px.imag(), box.bottom() - 30 + 1e-9);
    EXPECT_LT(std::abs(window.to_user(px) - p), 1e-12);
  }
  EXPECT_LT(window.to_px({0, 20}).imag(), window.to_px({0, 7}).imag());  // y goes up
}

TEST(PlaneWindow, OfOnePointHasAScale) {
  const std::array<Point, 1> points = {Point{3, 3}};
  EXPECT_GT(PlaneWindow(box, points, 10).scale(), 0);
}

TEST(PlaneWindow, ClipsToItsRectangle) {
  const PlaneWindow window(box, {}, 0);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-2000, 2000);
  for (int i = 0; i < 10'000; ++i) {
    const Point from{place(random), place(random)}, to{place(random), place(random)};
    const auto seen = window.clipped(from, to);
    bool meets = false;  // by brute force
    for (int k = 0; k <= 400; ++k) {
      const Point p = from + (k / 400.0) * (to - from);
      meets = meets || (p.real() > box.left && p.real() < box.right() && p.imag() > box.top && p.imag() < box.bottom());
    }
    EXPECT_TRUE(seen || !meets);
    if (!seen) continue;
    for (const Point end : {seen->first, seen->second}) {
      EXPECT_GE(end.real(), box.left - 21);
      EXPECT_LE(end.real(), box.right() + 21);
      EXPECT_GE(end.imag(), box.top - 21);
      EXPECT_LE(end.imag(), box.bottom() + 21);
    }
  }
}

TEST(PlaneWindow, CutsAPathWhereItLeaves) {
  const PlaneWindow window(box, {}, 0);
  const std::array<Point, 5> path = {Point{200, 100}, Point{300, 100}, Point{3000, 100}, Point{3000, 200},
                                     Point{200, 200}};
  const auto pieces = window.clipped(path);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].size(), 3u);
  EXPECT_EQ(pieces[1].back(), Point(200, 200));
}

TEST(PlaneWindow, RoundLengthsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(round_length(1), 1);
  EXPECT_DOUBLE_EQ(round_length(1.99), 1);
  EXPECT_DOUBLE_EQ(round_length(37), 20);
  EXPECT_DOUBLE_EQ(round_length(0.0073), 0.005);
  EXPECT_DOUBLE_EQ(round_length(0), 1);
}

}  // namespace
}  // namespace linkwright::plane_window_test
