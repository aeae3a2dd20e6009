#include "algebra/dense.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace linkwright::dense_test {
namespace {

constexpr double tiny = 1e-12;

class Numbers {
 public:
  double operator()() { return number_(random_); }
  template <std::size_t Rows, std::size_t Columns>
  DenseMatrix<Rows, Columns> matrix() {
    DenseMatrix<Rows, Columns> a;
    for (auto& row : a) std::generate(row.begin(), row.end(), [&] { return (*this)(); });
    return a;
  }
  Matrix3x3 matrix3x3() {
    Matrix3x3 a;
    for (Vector3& row : a.row) row = {(*this)(), (*this)(), (*this)()};
    return a;
  }

 private:
  std::mt19937_64 random_{31};
  std::uniform_real_distribution<double> number_{-1, 1};
};

template <std::size_t Rows, std::size_t Inner, std::size_t Columns>
DenseMatrix<Rows, Columns> product(const DenseMatrix<Rows, Inner>& a, const DenseMatrix<Inner, Columns>& b) {
  DenseMatrix<Rows, Columns> c{};
  for (std::size_t i = 0; i < Rows; ++i)
    for (std::size_t j = 0; j < Columns; ++j)
      for (std::size_t k = 0; k < Inner; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

template <std::size_t Rows, std::size_t Columns>
DenseMatrix<Columns, Rows> transposed(const DenseMatrix<Rows, Columns>& a) {
  DenseMatrix<Columns, Rows> t;
  for (std::size_t i = 0; i < Rows; ++i)
    for (std::size_t j = 0; j < Columns; ++j) t[j][i] = a[i][j];
  return t;
}

template <std::size_t Rows, std::size_t Columns>
double apart(const DenseMatrix<Rows, Columns>& a, const DenseMatrix<Rows, Columns>& b) {
  double most = 0;
  for (std::size_t i = 0; i < Rows; ++i)
    for (std::size_t j = 0; j < Columns; ++j) most = std::max(most, std::abs(a[i][j] - b[i][j]));
  return most;
}

template <std::size_t Size>
DenseMatrix<Size, Size> diagonal(const std::array<double, Size>& values) {
  DenseMatrix<Size, Size> a{};
  for (std::size_t i = 0; i < Size; ++i) a[i][i] = values[i];
  return a;
}

const DenseMatrix<4, 4> identity = diagonal<4>({1, 1, 1, 1});

TEST(Dense, SolutionsMeetTheirEquations) {
  Numbers random;
  const auto a = random.matrix<4, 4>();
  const std::array<double, 4> b = {random(), random(), random(), random()}, x = solve(a, b);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(a[i][0] * x[0] + a[i][1] * x[1] + a[i][2] * x[2] + a[i][3] * x[3], b[i], tiny);
  const Matrix3x3 c = random.matrix3x3();
  const Vector3 d{random(), random(), random()};
  EXPECT_LT(norm(c * solve(c, d) - d), tiny);
  // Of rank one, and nevertheless solved.
  const Matrix3x3 flat = dyadic_product({1, 2, 3}, {-1, 1, 2});
  EXPECT_LT(norm(flat * solve(flat, {2, 4, 6}) - Vector3{2, 4, 6}), tiny);
}

TEST(Dense, SmallMatricesAreSolvedAndInverted) {
  Numbers random;
  constexpr std::size_t size = 7;
  SmallMatrix a(size, size);
  std::array<double, size> b;
  for (std::size_t i = 0; i < size; ++i) {
    b[i] = random();
    for (std::size_t j = 0; j < size; ++j) {
      EXPECT_EQ(a(i, j), 0);
      a(i, j) = random();
    }
  }
  const auto inverted = inverse(a, tiny);
  ASSERT_TRUE(inverted);
  const auto x = solve(a, b).x;
  for (std::size_t i = 0; i < size; ++i) {
    double image = 0, inverse_of_b = 0;
    for (std::size_t j = 0; j < size; ++j) {
      image += a(i, j) * x[j];
      inverse_of_b += (*inverted)(i, j) * b[j];
    }
    EXPECT_NEAR(image, b[i], tiny);
    EXPECT_NEAR(inverse_of_b, x[i], tiny);
  }
  SmallMatrix two(2, 2);
  two(0, 1) = 3;
  two(1, 0) = 5;
  EXPECT_NEAR(solve(two, std::array{1.0, 1.0}).determinant, -15, tiny);
  two(1, 0) = 0;
  EXPECT_FALSE(inverse(two, tiny));
}

TEST(Dense, ShortestAndLeastSquares) {
  Numbers random;
  const auto wide = random.matrix<3, 6>();
  const std::array<double, 3> b = {random(), random(), random()};
  const auto x = shortest_solution(wide, b);
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double image = 0;
    for (std::size_t j = 0; j < 6; ++j) image += wide[i][j] * x[j];
    EXPECT_NEAR(image, b[i], tiny);
  }
  // The shortest one is a combination of the rows: x = Aᵀ (A Aᵀ)⁻¹ b.
  const auto gram = product(wide, transposed(wide));
  const Vector3 weights = solve(Matrix3x3{{{{gram[0][0], gram[0][1], gram[0][2]},
                                            {gram[1][0], gram[1][1], gram[1][2]},
                                            {gram[2][0], gram[2][1], gram[2][2]}}}},
                                {b[0], b[1], b[2]});
  for (std::size_t j = 0; j < 6; ++j)
    square += std::pow(x[j] - (wide[0][j] * weights.x + wide[1][j] * weights.y + wide[2][j] * weights.z), 2);
  EXPECT_LT(std::sqrt(square), tiny);

  const auto tall = random.matrix<10, 6>(), wanted = random.matrix<10, 6>();
  DenseMatrix<10, 6> off = product(tall, least_squares(tall, wanted));
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t j = 0; j < 6; ++j) off[i][j] -= wanted[i][j];
  EXPECT_LT(apart(product(transposed(tall), off), {}), tiny);
}

TEST(Dense, BasesAreOrthonormal) {
  Numbers random;
  const auto a = random.matrix<4, 3>();
  const auto basis = completed_basis(a);
  EXPECT_LT(apart(product(transposed(basis), basis), identity), tiny);
  const auto inside = product(transposed(basis), a);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < std::min<std::size_t>(i, 3); ++j) EXPECT_NEAR(inside[i][j], 0, tiny);

  const auto nine = product(random.matrix<15, 9>(), random.matrix<9, 12>());
  const auto outside = left_null_space(nine, tiny);
  ASSERT_TRUE(outside);
  EXPECT_LT(apart(product(transposed(*outside), nine), {}), tiny);
  EXPECT_LT(apart(product(transposed(*outside), *outside), diagonal<6>({1, 1, 1, 1, 1, 1})), tiny);
  EXPECT_FALSE(left_null_space(product(random.matrix<15, 8>(), random.matrix<8, 12>()), tiny));
}

TEST(Dense, SingularValuesTakeMatricesApart) {
  Numbers random;
  const auto a = random.matrix<4, 4>();
  const auto [left, right, values] = singular_values(a);
  EXPECT_LT(apart(product(product(left, diagonal(values)), transposed(right)), a), tiny);
  EXPECT_LT(apart(product(transposed(left), left), identity), tiny);
  EXPECT_LT(apart(product(transposed(right), right), identity), tiny);
  EXPECT_TRUE(std::is_sorted(values.rbegin(), values.rend()));
  EXPECT_NEAR(norm_of_inverse(a) * values[3], 1, 1e-9);
  EXPECT_EQ(norm_of_inverse({}), std::numeric_limits<double>::infinity());

  const Matrix3x3 b = random.matrix3x3();
  const auto of_b = singular_values(b);
  const auto stretched = [&](std::size_t i) { return of_b.values[i] * of_b.left.column(i); };
  EXPECT_LT(
      frobenius_norm(
          Matrix3x3::of_columns(stretched(0), stretched(1), stretched(2)) * linkwright::transposed(of_b.right) - b),
      tiny);
}

TEST(Dense, SingularValuesOfRowsKeepTheirDigits) {
  Numbers random;
  std::vector<Matrix3x3> matrices = {random.matrix3x3(), random.matrix3x3(), random.matrix3x3()};
  std::vector<std::array<double, 9>> rows(3);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 9; ++i) rows[k][i] = matrices[k](i / 3, i % 3);
  const RowSpace space = row_space(rows);
  const auto graded = graded_singular_values(matrices);
  ASSERT_EQ(graded.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(space.values[k], graded[k], tiny);
  for (const auto& row : rows) {  // in the space that the vectors span
    auto left = row;
    for (const auto& v : space.vectors) {
      double along = 0;
      for (std::size_t i = 0; i < 9; ++i) along += row[i] * v[i];
      for (std::size_t i = 0; i < 9; ++i) left[i] -= along * v[i];
    }
    for (const double element : left) EXPECT_NEAR(element, 0, tiny);
  }
  // Far below what is lost of the largest: at right angles to it up to rounding.
  const std::vector<Matrix3x3> far_apart = {1e20 * dyadic_product({1, 0, 0}, {1, 0, 0}),
                                            3 * dyadic_product({0, 1, 0}, {0, 1, 0})};
  EXPECT_NEAR(graded_singular_values(far_apart)[1], 3, tiny);
}

TEST(Dense, LeastImageIsShorterThanItsNeighbours) {
  Numbers random;
  const std::vector<Matrix3x3> matrices = {random.matrix3x3(), random.matrix3x3()};
  const auto image = [&](Vector3 v) { return std::hypot(norm(matrices[0] * v), norm(matrices[1] * v)); };
  const auto [vector, length] = least_image(matrices);
  EXPECT_NEAR(norm(vector), 1, tiny);
  EXPECT_NEAR(image(vector), length, tiny);
  for (int i = 0; i < 100; ++i)
    EXPECT_GE(image(normalized(vector + 0.1 * Vector3{random(), random(), random()})), length);
}

TEST(Dense, PrincipalAxesOfASymmetricMatrix) {
  Numbers random;
  const Matrix3x3 any = random.matrix3x3(), a = any + transposed(any);
  const auto [values, axes] = principal_axes(a);
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(norm(a * axes[i] - values[i] * axes[i]), tiny);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(dot(axes[i], axes[j]), i == j, tiny);
  }
}

TEST(Dense, EigenPairsAreTheMatrixsOwn) {
  Numbers random;
  const auto a = random.matrix<6, 6>();
  const EigenPairs pairs = eigen_pairs(a);
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t i = 0; i < 6; ++i) {
      std::complex<double> image = 0;
      for (std::size_t j = 0; j < 6; ++j) image += a[i][j] * pairs.vectors[k][j];
      EXPECT_LT(std::abs(image - pairs.values[k] * pairs.vectors[k][i]), tiny);
    }
    if (pairs.values[k].imag() > 0) {
      EXPECT_LT(std::abs(pairs.values[k + 1] - std::conj(pairs.values[k])), tiny);
    }
  }
}

TEST(Dense, AllRootsOfAPolynomial) {
  // (t − 2)(t + 3)(t² + 1)
  auto roots = all_roots(std::array{-6.0, 1.0, -5.0, 1.0, 1.0});
  ASSERT_EQ(roots.size(), 4u);
  const std::complex<double> i{0, 1};
  for (const auto expected : {std::complex<double>(2), std::complex<double>(-3), i, -i})
    EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), [&](auto root) { return std::abs(root - expected) < tiny; }));
  // (t − i)(t − 2)
  roots = all_roots(std::array<std::complex<double>, 3>{2.0 * i, -2.0 - i, 1.0});
  ASSERT_EQ(roots.size(), 2u);
  for (const auto expected : {std::complex<double>(2), i})
    EXPECT_TRUE(std::any_of(roots.begin(), roots.end(), [&](auto root) { return std::abs(root - expected) < tiny; }));
}

}  // namespace
}  // namespace linkwright::dense_test
