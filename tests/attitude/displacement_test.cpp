#include "linkwright/attitude/displacement.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"
#include "support/group_laws.hpp"

namespace linkwright::displacement_test {
namespace {

using testing::ulps_between;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Translations of size 1 to 2.
Displacement random_displacement(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(1, 2);
  const Rotation rotation(testing::random_rotation(random));
  return {rotation, length(random) * testing::random_direction(random)};
}

double ulps(const Displacement& a, const Displacement& b) {
  return std::max(ulps_between(a.rotation, b.rotation), ulps_between(a.translation, b.translation));
}

const testing::Group<Displacement> displacements{random_displacement, [](const Displacement& a) { return a.inverse(); },
                                                 ulps};

/// The product of 4×4 matrices, as the schoolbook has it.
Matrix4x4 product(const Matrix4x4& a, const Matrix4x4& b) {
  Matrix4x4 c{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

TEST(Displacement, IsAGroup) { testing::expect_group_laws(displacements, 12); }

TEST(Displacement, ActsOnPointsAndDirectionsAsItsFactorsDo) {
  const auto distance = [](const Vector3& a, const Vector3& b) { return ulps_between(a, b); };
  testing::expect_action_laws<Displacement, Vector3>(
      displacements, [](const Displacement& t, const Vector3& r) { return t.apply_to_point(r); },
      testing::random_direction, distance, 12);
  testing::expect_action_laws<Displacement, Vector3>(
      displacements, [](const Displacement& t, const Vector3& u) { return t.apply_to_direction(u); },
      testing::random_direction, distance, 6);
}

TEST(Displacement, MovesPointsAndTurnsDirections) {
  const Displacement t{Rotation::about_z(pi / 2), {10, 20, 30}};
  EXPECT_LE(ulps_between(t.apply_to_point({1, 0, 0}), {10, 21, 30}), 0);
  EXPECT_LE(ulps_between(t.apply_to_direction({1, 0, 0}), {0, 1, 0}), 1);
  EXPECT_EQ(Displacement::translated({1, 2, 3}).apply_to_point({1, 1, 1}), (Vector3{2, 3, 4}));
}

TEST(Displacement, ProductIsTheProductOfTheMatrices) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Displacement a = random_displacement(random), b = random_displacement(random);
    const Matrix4x4 of_product = (a * b).matrix(), matrices = product(a.matrix(), b.matrix());
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = 0; column < 4; ++column)
        EXPECT_LE(ulps_between(of_product[row][column], matrices[row][column]), 4);
  }
}

TEST(Displacement, MatrixReadsBackBitIdentical) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Displacement a = random_displacement(random);
    const Result<Displacement> b = Displacement::from_matrix(a.matrix());
    ASSERT_TRUE(b.ok());
    EXPECT_EQ(*b, a);
  }
}

TEST(Displacement, RenormalizedUndoesTheDriftOfLongProducts) {
  std::mt19937_64 random(5);
  Displacement t;
  for (int i = 0; i < 100000; ++i) t = t * Displacement{Rotation(testing::random_rotation(random)), {}};
  const auto defect = [](const Displacement& a) {
    return ulps_between(a.rotation.matrix() * transposed(a.rotation.matrix()), Matrix3x3::identity());
  };
  EXPECT_GT(defect(t), 10);
  EXPECT_LE(defect(t.renormalized()), 4);
}

TEST(Displacement, NamesWhatIsWrongWithAMatrix) {
  const Matrix4x4 good = Displacement{Rotation::about_x(0.3), {1, 2, 3}}.matrix();
  const auto code = [&](std::size_t row, std::size_t column, double value) {
    Matrix4x4 bad = good;
    bad[row][column] = value;
    const Result<Displacement> result = Displacement::from_matrix(bad);
    return result ? std::string("none") : result.errors().front().code;
  };
  EXPECT_EQ(code(0, 0, 1), "none");
  EXPECT_EQ(code(0, 3, nan), "not_finite");
  EXPECT_EQ(code(1, 1, -infinity), "not_finite");
  EXPECT_EQ(code(3, 3, nan), "not_finite");
  EXPECT_EQ(code(3, 0, 0.5), "last_row");
  EXPECT_EQ(code(3, 3, 0), "last_row");
  EXPECT_EQ(code(3, 3, 2), "last_row");
  EXPECT_EQ(code(3, 3, 1 + 1e-9), "none");
  EXPECT_EQ(code(0, 0, 1.5), "not_orthogonal");
  EXPECT_EQ(code(0, 0, -1), "reflection");
}

TEST(Displacement, MatrixOfColumnsIsRefusedByItsLastRow) {
  Matrix4x4 t = Displacement::translated({1, 2, 3}).matrix();
  for (std::size_t i = 0; i < 3; ++i) std::swap(t[i][3], t[3][i]);
  const Result<Displacement> result = Displacement::from_matrix(t);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.errors().front().message.find("[1, 2, 3, 1]"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::displacement_test
