#include "algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

using Eigen::Index;

/// One type for all: each size of its own would be compiled anew, the larger ones unrolled (minutes of compiling).
using Small =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, SmallMatrix::most, SmallMatrix::most>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, SmallMatrix::most, 1>;

template <std::size_t Rows, std::size_t Columns>
Small to_eigen(const DenseMatrix<Rows, Columns>& a) {
  Small m(static_cast<Index>(Rows), static_cast<Index>(Columns));
  for (std::size_t i = 0; i < Rows; ++i)
    for (std::size_t j = 0; j < Columns; ++j) m(static_cast<Index>(i), static_cast<Index>(j)) = a[i][j];
  return m;
}

Small to_eigen(const SmallMatrix& a) {
  return Eigen::Map<const Eigen::MatrixXd>(a.by_columns(), static_cast<Index>(a.rows()),
                                           static_cast<Index>(a.columns()));
}

// Side by side, the rows of one under those of the other.
Small to_eigen(std::span<const Matrix3x3> matrices) {
  Small m(static_cast<Index>(3 * matrices.size()), 3);
  for (std::size_t i = 0; i < 3 * matrices.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) m(static_cast<Index>(i), static_cast<Index>(j)) = matrices[i / 3](i % 3, j);
  return m;
}
Small to_eigen(const Matrix3x3& a) { return to_eigen(std::span(&a, 1)); }

Vector to_eigen(std::span<const double> v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Index>(v.size()));
}

template <std::size_t Rows, std::size_t Columns>
DenseMatrix<Rows, Columns> dense(const Small& m) {
  DenseMatrix<Rows, Columns> a;
  for (std::size_t i = 0; i < Rows; ++i)
    for (std::size_t j = 0; j < Columns; ++j) a[i][j] = m(static_cast<Index>(i), static_cast<Index>(j));
  return a;
}

template <std::size_t Size>
std::array<double, Size> array_of(const Vector& v) {
  std::array<double, Size> a;
  for (std::size_t i = 0; i < Size; ++i) a[i] = v[static_cast<Index>(i)];
  return a;
}

Vector3 vector3(const Vector& v) { return {v[0], v[1], v[2]}; }

Matrix3x3 matrix3x3(const Small& m) {
  return Matrix3x3::of_columns(vector3(m.col(0)), vector3(m.col(1)), vector3(m.col(2)));
}

using Svd = Eigen::JacobiSVD<Small>;
constexpr unsigned both = Eigen::ComputeFullU | Eigen::ComputeFullV;

// Of a symmetric matrix without negative ones: Newton's method on the characteristic polynomial, its coefficients from
// the traces of powers, comes down to its largest root from above without passing it.
double largest_eigenvalue(const Eigen::Matrix4d& matrix) {
  constexpr double resolution = 1e-10;
  constexpr int most_steps = 50;
  const double trace = matrix.trace();
  const Eigen::Matrix4d unit = matrix / trace, square = unit * unit;
  const double p2 = square.trace(), p3 = square.cwiseProduct(unit).sum(), p4 = square.squaredNorm();
  const double e2 = (1 - p2) / 2, e3 = (e2 - p2 + p3) / 3, e4 = (e3 - e2 * p2 + p3 - p4) / 4;
  double root = std::sqrt(p2);
  for (int step = 0; step < most_steps; ++step) {
    const double value = (((root - 1) * root + e2) * root - e3) * root + e4;
    const double slope = ((4 * root - 3) * root + 2 * e2) * root - e3;
    const double next = root - value / slope;
    if (!(next < (1 - resolution) * root)) break;
    root = next;
  }
  return trace * root;
}

template <class Number>
Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> companion_of(std::span<const Number> c) {
  const auto degree = static_cast<Index>(c.size()) - 1;
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> companion =
      Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>::Zero(degree, degree);
  for (Index i = 0; i < degree; ++i) {
    companion(i, degree - 1) = -c[static_cast<std::size_t>(i)] / c.back();
    if (i > 0) companion(i, i - 1) = 1;
  }
  return companion;
}

}  // namespace

SmallMatrix::SmallMatrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns) {
  require(rows <= most && columns <= most, "a small matrix");
  std::fill_n(by_columns_.begin(), rows * columns, 0.0);
}

std::array<double, 4> solve(const DenseMatrix<4, 4>& a, const std::array<double, 4>& b) {
  return array_of<4>(Eigen::PartialPivLU<Small>(to_eigen(a)).solve(to_eigen(b)));
}

LinearSolution solve(const SmallMatrix& a, std::span<const double> b) {
  const Eigen::PartialPivLU<Small> factors(to_eigen(a));
  const Vector found = factors.solve(to_eigen(b.first(a.rows())));
  LinearSolution solution;
  std::copy(found.begin(), found.end(), solution.x.begin());
  solution.determinant = factors.determinant();
  return solution;
}

Vector3 solve(const Matrix3x3& a, Vector3 b) {
  return vector3(Eigen::FullPivLU<Small>(to_eigen(a)).solve(to_eigen(std::array{b.x, b.y, b.z})));
}

std::optional<SmallMatrix> inverse(const SmallMatrix& a, double least_pivot) {
  const Eigen::FullPivLU<Small> factors(to_eigen(a));
  const Vector pivots = factors.matrixLU().diagonal().cwiseAbs();
  if (!(pivots.minCoeff() >= least_pivot * pivots.maxCoeff())) return std::nullopt;
  SmallMatrix inverse(a.rows(), a.columns());
  for (std::size_t j = 0; j < a.columns(); ++j) {
    const Vector column = factors.solve(Vector::Unit(static_cast<Index>(a.rows()), static_cast<Index>(j)));
    for (std::size_t i = 0; i < a.rows(); ++i) inverse(i, j) = column[static_cast<Index>(i)];
  }
  return inverse;
}

std::array<double, 6> shortest_solution(const DenseMatrix<3, 6>& a, const std::array<double, 3>& b) {
  const Svd svd(to_eigen(a), both);
  const Vector values = svd.singularValues(), right_side = to_eigen(b);
  Vector found = Vector::Zero(6);
  for (Index k = 0; k < 3; ++k)
    if (values[k] > 3 * std::numeric_limits<double>::epsilon() * values[0])
      found += svd.matrixU().col(k).dot(right_side) / values[k] * svd.matrixV().col(k);
  return array_of<6>(found);
}

DenseMatrix<6, 6> least_squares(const DenseMatrix<10, 6>& a, const DenseMatrix<10, 6>& b) {
  return dense<6, 6>(Eigen::HouseholderQR<Small>(to_eigen(a)).solve(to_eigen(b)));
}

DenseMatrix<4, 4> completed_basis(const DenseMatrix<4, 3>& a) {
  return dense<4, 4>(Eigen::HouseholderQR<Small>(to_eigen(a)).householderQ());
}

std::optional<DenseMatrix<15, 6>> left_null_space(const DenseMatrix<15, 12>& a, double least_pivot) {
  constexpr int rows = 15, dimension = 6, rank = rows - dimension;
  const Eigen::ColPivHouseholderQR<Small> qr(to_eigen(a));
  const Small& triangle = qr.matrixQR();
  if (!(std::abs(triangle(rank - 1, rank - 1)) > least_pivot * std::abs(triangle(0, 0)))) return std::nullopt;
  Small found = Small::Zero(rows, dimension);
  found.bottomRows(dimension).setIdentity();
  for (int k = rank - 1; k >= 0; --k) {
    const int tail = rows - k - 1;
    std::array<double, dimension> workspace;
    found.bottomRows(tail + 1).applyHouseholderOnTheLeft(triangle.col(k).tail(tail), qr.hCoeffs()[k], workspace.data());
  }
  return dense<rows, dimension>(found);
}

SingularValues<Matrix3x3, 3> singular_values(const Matrix3x3& a) {
  const Svd svd(to_eigen(a), both);
  return {matrix3x3(svd.matrixU()), matrix3x3(svd.matrixV()), array_of<3>(svd.singularValues())};
}

SingularValues<DenseMatrix<4, 4>, 4> singular_values(const DenseMatrix<4, 4>& a) {
  const Svd svd(to_eigen(a), both);
  return {dense<4, 4>(svd.matrixU()), dense<4, 4>(svd.matrixV()), array_of<4>(svd.singularValues())};
}

RowSpace row_space(std::span<const std::array<double, 9>> rows) {
  Small stacked(static_cast<Index>(rows.size()), 9);
  for (std::size_t i = 0; i < rows.size(); ++i) stacked.row(static_cast<Index>(i)) = to_eigen(rows[i]).transpose();
  const Svd svd(stacked, Eigen::ComputeThinV);
  RowSpace found;
  for (Index k = 0; k < svd.singularValues().size(); ++k) {
    found.values.push_back(svd.singularValues()[k]);
    found.vectors.push_back(array_of<9>(svd.matrixV().col(k)));
  }
  return found;
}

// Columns of nine, turned in pairs until all are at right angles; their lengths are the singular values (M. R.
// Hestenes, Inversion of matrices by biorthogonalization and related results, 1958).
std::vector<double> graded_singular_values(std::span<const Matrix3x3> matrices) {
  constexpr int most_matrices = 4, most_sweeps = 30;  // six sweeps are usual
  constexpr double right_angle = 1e-15;
  require(matrices.size() <= most_matrices, "at most four matrices");
  Small columns(9, static_cast<Index>(matrices.size()));
  for (std::size_t k = 0; k < matrices.size(); ++k)
    for (std::size_t i = 0; i < 9; ++i)
      columns(static_cast<Index>(i), static_cast<Index>(k)) = matrices[k](i / 3, i % 3);
  bool turned = true;
  for (int sweep = 0; turned && sweep < most_sweeps; ++sweep) {
    turned = false;
    for (Index j = 1; j < columns.cols(); ++j)
      for (Index i = 0; i < j; ++i) {
        const double p = columns.col(i).squaredNorm(), q = columns.col(j).squaredNorm(),
                     inner = columns.col(i).dot(columns.col(j));
        if (!(std::abs(inner) > right_angle * std::sqrt(p * q))) continue;
        const double cotangent = (q - p) / (2 * inner);
        const double tangent =
            std::copysign(1.0, cotangent) / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent));
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
        const Vector before = columns.col(i);
        columns.col(i) = cosine * before - sine * columns.col(j);
        columns.col(j) = sine * before + cosine * columns.col(j);
        turned = true;
      }
  }
  std::vector<double> values;
  for (Index i = 0; i < columns.cols(); ++i) values.push_back(columns.col(i).norm());
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

LeastImage least_image(std::span<const Matrix3x3> matrices) {
  const Svd svd(to_eigen(matrices), Eigen::ComputeFullV);
  return {vector3(svd.matrixV().col(2)), svd.singularValues()[2]};
}

double norm_of_inverse(const DenseMatrix<4, 4>& a) {
  const Eigen::Matrix4d inverse = Eigen::Matrix4d(to_eigen(a)).inverse(), square = inverse * inverse.transpose();
  return square.allFinite() ? std::sqrt(largest_eigenvalue(square)) : std::numeric_limits<double>::infinity();
}

PrincipalAxes principal_axes(const Matrix3x3& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> found(Eigen::Matrix3d(to_eigen(symmetric)));
  const Eigen::Matrix3d& vectors = found.eigenvectors();
  return {array_of<3>(found.eigenvalues()),
          {vector3(vectors.col(0)), vector3(vectors.col(1)), vector3(vectors.col(2))}};
}

EigenPairs eigen_pairs(const DenseMatrix<6, 6>& a) {
  const Eigen::EigenSolver<Small> found(to_eigen(a));
  const auto vectors = found.eigenvectors();
  EigenPairs pairs;
  for (std::size_t k = 0; k < 6; ++k) {
    pairs.values[k] = found.eigenvalues()[static_cast<Index>(k)];
    for (std::size_t i = 0; i < 6; ++i) pairs.vectors[k][i] = vectors(static_cast<Index>(i), static_cast<Index>(k));
  }
  return pairs;
}

std::vector<Vector3> pencil_vectors(const Matrix3x3& a, const Matrix3x3& b) {
  const auto fixed_size = [](const Matrix3x3& m) {
    Eigen::Matrix3d same;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) same(static_cast<Index>(i), static_cast<Index>(j)) = m(i, j);
    return same;
  };
  const Eigen::GeneralizedEigenSolver<Eigen::Matrix3d> pencil(fixed_size(a), fixed_size(b));
  std::vector<Vector3> found;
  if (pencil.info() != Eigen::Success) return found;
  for (Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d real = pencil.eigenvectors().col(i).real();
    if (real.norm() > 0 && real.allFinite()) found.push_back(normalized(Vector3{real[0], real[1], real[2]}));
  }
  return found;
}

std::vector<std::complex<double>> all_roots(std::span<const double> coefficients) {
  const auto roots = Eigen::EigenSolver<Small>(companion_of(coefficients), false).eigenvalues();
  return {roots.begin(), roots.end()};
}

std::vector<std::complex<double>> all_roots(std::span<const std::complex<double>> coefficients) {
  const auto roots = Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(companion_of(coefficients), false).eigenvalues();
  return {roots.begin(), roots.end()};
}

}  // namespace linkwright
