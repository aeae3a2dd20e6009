#include "linkwright/algebra/homogeneous.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace linkwright::homogeneous_test {
namespace {

constexpr Homogeneous a{1, 2, -3}, b{-0.5, 4, 1}, c{2, 0, 7};

TEST(Homogeneous, IsThePointWhateverItsScale) {
  for (const double scale : {1.0, -2.0, 1e-30, 1e30}) {
    const auto point = finite_point(scale * Homogeneous::of({3, -4}));
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(std::abs(*point - Point{3, -4}), 0, 1e-14);
  }
}

TEST(Homogeneous, HasNoFinitePointAtInfinity) {
  EXPECT_TRUE(is_at_infinity(Homogeneous::at_infinity({1, 2})));
  EXPECT_EQ(finite_point(Homogeneous::at_infinity({1, 2})), std::nullopt);
  EXPECT_FALSE(is_at_infinity(Homogeneous::of({1e8, 0})));
  EXPECT_TRUE(is_at_infinity(Homogeneous::of({1e10, 0})));
}

TEST(Homogeneous, OfNanIsAtInfinityAndNoPoint) {
  EXPECT_EQ(finite_point({std::nan(""), 1, 1}), std::nullopt);
  EXPECT_EQ(finite_point({1, std::nan(""), 1}), std::nullopt);
}

TEST(Homogeneous, NullIsNoPointAndStaysNull) {
  EXPECT_EQ(normalized(Homogeneous{}), Homogeneous{});
  EXPECT_NEAR(norm(normalized(b)), 1, 1e-15);
}

TEST(Homogeneous, CrossIsTheLineThroughTwoPoints) {
  const Homogeneous line = cross(a, b);
  EXPECT_NEAR(dot(line, a), 0, 1e-14);
  EXPECT_NEAR(dot(line, b), 0, 1e-14);
  EXPECT_EQ(cross(a, 3.0 * a), Homogeneous{});
}

TEST(Homogeneous, ParallelLinesMeetAtInfinity) {
  const Homogeneous x_is_1{-1, 1, 0}, x_is_2{-2, 1, 0};
  EXPECT_TRUE(is_at_infinity(cross(x_is_1, x_is_2)));
}

TEST(Homogeneous, DeterminantIsAlternating) {
  EXPECT_DOUBLE_EQ(determinant(a, b, c), determinant(b, c, a));
  EXPECT_DOUBLE_EQ(determinant(a, b, c), -determinant(b, a, c));
  EXPECT_NEAR(determinant(a, b, a + 2.0 * b), 0, 1e-14);
}

TEST(HomogeneousMatrix, ProductFromTheLeftIsThatOfTheTransposed) {
  const HomogeneousMatrix m{{a, b, c}};
  const Homogeneous v{1, -1, 2};
  EXPECT_NEAR(norm(v * m - transposed(m) * v), 0, 1e-14);
  EXPECT_EQ(HomogeneousMatrix::identity() * v, v);
  EXPECT_DOUBLE_EQ(dot(v, m * b), dot(v * m, b));
}

}  // namespace
}  // namespace linkwright::homogeneous_test
