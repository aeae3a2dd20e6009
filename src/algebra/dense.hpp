#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/matrix3x3.hpp"

// What the library needs of the linear algebra of dense matrices, for the sizes that occur. dense.cpp alone includes
// Eigen, whose templates are long to compile.

namespace linkwright {

/// A matrix of known size, by rows.
template <std::size_t Rows, std::size_t Columns>
using DenseMatrix = std::array<std::array<double, Columns>, Rows>;

/// A matrix whose size is known when the program runs, zero at first.
class SmallMatrix {
 public:
  static constexpr std::size_t most = 16;  ///< rows, and columns

  SmallMatrix(std::size_t rows, std::size_t columns);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double& operator()(std::size_t row, std::size_t column) { return by_columns_[column * rows_ + row]; }
  [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
    return by_columns_[column * rows_ + row];
  }
  [[nodiscard]] const double* by_columns() const { return by_columns_.data(); }

 private:
  std::size_t rows_, columns_;
  std::array<double, most * most> by_columns_;
};

// Linear equations.

/// x of A x = b; not finite where A is singular.
[[nodiscard]] std::array<double, 4> solve(const DenseMatrix<4, 4>& a, const std::array<double, 4>& b);

/// x of A x = b, pivots taken from all of A: where it is singular, one of the solutions if there are any.
[[nodiscard]] Vector3 solve(const Matrix3x3& a, Vector3 b);

/// The first a.rows() of x; with the determinant of A.
struct LinearSolution {
  std::array<double, SmallMatrix::most> x{};
  double determinant = 0;
};
/// x of A x = b; not finite where A is singular.
[[nodiscard]] LinearSolution solve(const SmallMatrix& a, std::span<const double> b);

/// Nothing where the least pivot, of the largest, is below `least_pivot`.
[[nodiscard]] std::optional<SmallMatrix> inverse(const SmallMatrix& a, double least_pivot);

/// The shortest x of A x = b.
[[nodiscard]] std::array<double, 6> shortest_solution(const DenseMatrix<3, 6>& a, const std::array<double, 3>& b);

/// X for which the columns of A X − B are shortest.
[[nodiscard]] DenseMatrix<6, 6> least_squares(const DenseMatrix<10, 6>& a, const DenseMatrix<10, 6>& b);

// Subspaces, by orthonormal columns.

/// Three columns that span those of A one after the other, and a fourth at right angles to them.
[[nodiscard]] DenseMatrix<4, 4> completed_basis(const DenseMatrix<4, 3>& a);

/// At right angles to all columns of A, of which nine are independent: nothing where the ninth pivot, of the first, is
/// not above `least_pivot`.
[[nodiscard]] std::optional<DenseMatrix<15, 6>> left_null_space(const DenseMatrix<15, 12>& a, double least_pivot);

// Singular values, falling.

/// A = left · diag(values) · rightᵀ.
template <class Matrix, std::size_t Size>
struct SingularValues {
  Matrix left, right;
  std::array<double, Size> values{};
};
[[nodiscard]] SingularValues<Matrix3x3, 3> singular_values(const Matrix3x3& a);
[[nodiscard]] SingularValues<DenseMatrix<4, 4>, 4> singular_values(const DenseMatrix<4, 4>& a);

/// The rows' singular values, as many as there are rows, at most nine, and unit vectors that span the same space.
struct RowSpace {
  std::vector<double> values;
  std::vector<std::array<double, 9>> vectors;
};
[[nodiscard]] RowSpace row_space(std::span<const std::array<double, 9>> rows);

/// Of at most four matrices as vectors of nine: each with digits of its own, however small beside the others.
[[nodiscard]] std::vector<double> graded_singular_values(std::span<const Matrix3x3> matrices);

/// The unit vector whose images by all matrices are shortest together, and how long they are.
struct LeastImage {
  Vector3 vector;
  double length = 0;
};
[[nodiscard]] LeastImage least_image(std::span<const Matrix3x3> matrices);

/// The largest singular value of the inverse; infinite where there is none.
[[nodiscard]] double norm_of_inverse(const DenseMatrix<4, 4>& a);

// Eigenvalues.

/// Of a symmetric matrix, rising, with unit eigenvectors at right angles.
struct PrincipalAxes {
  std::array<double, 3> values{};
  std::array<Vector3, 3> axes{};
};
[[nodiscard]] PrincipalAxes principal_axes(const Matrix3x3& symmetric);

/// Of any matrix: complex ones in conjugate pairs, one after the other; vectors[k] of unit length.
struct EigenPairs {
  std::array<std::complex<double>, 6> values{};
  std::array<std::array<std::complex<double>, 6>, 6> vectors{};
};
[[nodiscard]] EigenPairs eigen_pairs(const DenseMatrix<6, 6>& a);

/// All roots of c₀ + c₁ t + …, whose last coefficient is not zero, as eigenvalues of the companion matrix.
[[nodiscard]] std::vector<std::complex<double>> all_roots(std::span<const double> coefficients);
[[nodiscard]] std::vector<std::complex<double>> all_roots(std::span<const std::complex<double>> coefficients);

}  // namespace linkwright
