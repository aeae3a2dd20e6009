#include "linkwright/algebra/vector3.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace linkwright::vector3_test {
namespace {

constexpr Vector3 a{1, 2, -3}, b{-0.5, 4, 1}, c{2, 0, 7};

TEST(Vector3, CrossIsPerpendicularAndRightHanded) {
  EXPECT_EQ(dot(cross(a, b), a), 0);
  EXPECT_EQ(dot(cross(a, b), b), 0);
  EXPECT_EQ(cross(Vector3{1, 0, 0}, Vector3{0, 1, 0}), (Vector3{0, 0, 1}));
}

TEST(Vector3, DoubleCrossExpands) { EXPECT_EQ(cross(a, cross(b, c)), dot(a, c) * b - dot(a, b) * c); }

TEST(Vector3, DeterminantIsAlternating) {
  EXPECT_EQ(determinant(a, b, c), determinant(b, c, a));
  EXPECT_EQ(determinant(a, b, c), -determinant(b, a, c));
  EXPECT_EQ(determinant(a, b, a), 0);
}

TEST(Vector3, IndexIsTheCoordinate) {
  Vector3 v = a;
  v[1] = 9;
  EXPECT_EQ(v, (Vector3{1, 9, -3}));
  EXPECT_EQ(v[0] + v[1] + v[2], 7);
}

TEST(Vector3, NormalizesEveryFiniteLength) {
  for (const double scale : {1.0, 1e-300, 5e-324, 1e-160, 1e160, 1e308}) {
    const Vector3 unit = normalized(scale * Vector3{1, -1, 0});
    EXPECT_NEAR(unit.x, std::numbers::sqrt2 / 2, 2e-16) << scale;
    EXPECT_NEAR(unit.y, -std::numbers::sqrt2 / 2, 2e-16) << scale;
    EXPECT_EQ(unit.z, 0) << scale;
  }
  EXPECT_EQ(normalized(Vector3{}), Vector3{});
}

TEST(Vector3, NormNeitherOverflowsNorUnderflows) {
  for (const double scale : {1e-300, 1e-140, 1.0, 1e149, 1e150, 1e151, 1e300})
    EXPECT_DOUBLE_EQ(norm(scale * Vector3{2, 3, 6}), 7 * scale);
  EXPECT_EQ(norm(Vector3{}), 0);
}

TEST(Vector3, NormOfNoNumberIsNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(norm(Vector3{nan, 0, 0})));
  EXPECT_TRUE(std::isnan(norm(Vector3{0, nan, 0})));
  EXPECT_TRUE(std::isnan(norm(Vector3{1, 0, nan})));
}

TEST(Vector3, AngleIsExactNearNothingAndNearAHalfTurn) {
  const Vector3 x{1, 0, 0};
  for (const double angle : {1e-12, 1e-3, 1.0, 3.0}) {
    EXPECT_DOUBLE_EQ(angle_between(x, {std::cos(angle), std::sin(angle), 0}), angle);
    EXPECT_DOUBLE_EQ(angle_between(x, {-std::cos(angle), 0, std::sin(angle)}), std::numbers::pi - angle);
  }
  EXPECT_EQ(angle_between(x, {}), 0);
}

TEST(Vector3, KnowsWhatIsNotFinite) {
  EXPECT_TRUE(is_finite(a));
  EXPECT_FALSE(is_finite(Vector3{0, std::numeric_limits<double>::quiet_NaN(), 0}));
  EXPECT_FALSE(is_finite(Vector3{0, 0, std::numeric_limits<double>::infinity()}));
}

}  // namespace
}  // namespace linkwright::vector3_test
