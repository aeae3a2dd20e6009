#include "linkwright/algebra/point.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright::point_test {
namespace {

TEST(Point, ProductsAreRealAndImaginaryPartOfConjugateTimes) {
  const Point u{3, -2}, v{0.5, 7};
  EXPECT_DOUBLE_EQ(dot(u, v), (std::conj(u) * v).real());
  EXPECT_DOUBLE_EQ(cross(u, v), (std::conj(u) * v).imag());
}

TEST(Point, CrossIsPositiveCounterClockwise) {
  EXPECT_GT(cross(Point{1, 0}, Point{1, 0.1}), 0);
  EXPECT_LT(cross(Point{1, 0}, Point{1, -0.1}), 0);
  EXPECT_EQ(cross(Point{2, 3}, Point{-4, -6}), 0);
}

TEST(Point, DirectionTurnsCounterClockwise) {
  EXPECT_NEAR(std::abs(direction(pi / 2) * Point{2, 0} - Point{0, 2}), 0, 1e-15);
  EXPECT_NEAR(std::arg(direction(0.7) * direction(0.4)), 1.1, 1e-15);
}

TEST(Point, IsFiniteOnlyInBothCoordinates) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_finite(Point{1e300, -1e300}));
  EXPECT_FALSE(is_finite(Point{0, infinite}));
  EXPECT_FALSE(is_finite(Point{std::nan(""), 0}));
}

}  // namespace
}  // namespace linkwright::point_test
