#include "linkwright/algebra/matrix3x3.hpp"

#include <gtest/gtest.h>

namespace linkwright::matrix3x3_test {
namespace {

// Small whole numbers: every result below is exact.
constexpr Vector3 a{1, 2, -3}, b{-4, 4, 1}, c{2, 0, 7};
constexpr Matrix3x3 m{{a, b, c}}, n{{{{0, 1, 5}, {2, -2, 1}, {3, 1, 1}}}};

TEST(Matrix3x3, ProductIsAssociativeWithVectors) {
  EXPECT_EQ((m * n) * a, m * (n * a));
  EXPECT_EQ(a * (m * n), (a * m) * n);
  EXPECT_EQ(m * Matrix3x3::identity(), m);
}

TEST(Matrix3x3, TransposedSwapsRowsAndColumns) {
  EXPECT_EQ(transposed(m), Matrix3x3::of_columns(a, b, c));
  EXPECT_EQ(transposed(m).column(1), b);
  EXPECT_EQ(transposed(m * n), transposed(n) * transposed(m));
  EXPECT_EQ(a * m, transposed(m) * a);
}

TEST(Matrix3x3, DeterminantIsMultiplicative) {
  EXPECT_EQ(determinant(m * n), determinant(m) * determinant(n));
  EXPECT_EQ(determinant(m), 112);
}

TEST(Matrix3x3, CofactorsMakeTheInverse) {
  EXPECT_EQ(m * transposed(cofactors(m)), determinant(m) * Matrix3x3::identity());
}

TEST(Matrix3x3, DyadicProductPicksTheSecondFactor) {
  EXPECT_EQ(dyadic_product(a, b) * c, dot(b, c) * a);
  EXPECT_EQ(c * dyadic_product(a, b), dot(c, a) * b);
}

TEST(Matrix3x3, SkewMatrixIsTheCrossProduct) {
  EXPECT_EQ(skew_matrix(a) * b, cross(a, b));
  EXPECT_EQ(axial_vector(skew_matrix(a)), a);
  EXPECT_EQ(axial_vector(skew_matrix(a) + Matrix3x3::identity()), a) << "the symmetric part does not count";
}

TEST(Matrix3x3, ElementsSumsAndNorms) {
  Matrix3x3 k = m;
  k(2, 0) = 8;
  EXPECT_EQ(k(2, 0), 8);
  EXPECT_EQ(trace(m), 12);
  EXPECT_EQ((m + n) - n, m);
  EXPECT_EQ(2.0 * m, m + m);
  EXPECT_DOUBLE_EQ(frobenius_norm(dyadic_product(a, b)), norm(a) * norm(b));
}

}  // namespace
}  // namespace linkwright::matrix3x3_test
