#include "linkwright/attitude/nearest_rotation.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

Eigen::Matrix3d to_eigen(const Matrix3x3& a) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = a(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return m;
}

Matrix3x3 from_eigen(const Eigen::Matrix3d& m) {
  Matrix3x3 a;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) a(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = m(i, j);
  return a;
}

/// A power of two near the largest element, which no digit is lost to; 1 for the null matrix.
double power_of_two(const Matrix3x3& a) {
  double largest = 0;
  for (const Vector3& row : a.row)
    for (const double element : {row.x, row.y, row.z}) largest = std::fmax(largest, std::fabs(element));
  return largest > 0 ? std::scalbn(1.0, std::ilogb(largest)) : 1;
}

}  // namespace

Result<NearestRotation> nearest_rotation(const Matrix3x3& c_ij) {
  if (!is_finite(c_ij))
    return Error{"not_finite", "matrix", "an element is not a number or infinite: give nine finite numbers"};
  const double scale = power_of_two(c_ij);
  Matrix3x3 scaled = c_ij;
  for (Vector3& row : scaled.row) row = row / scale;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(to_eigen(scaled), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d& u = svd.matrixU();
  const Eigen::Matrix3d& v = svd.matrixV();
  const double sign = determinant(from_eigen(u * v.transpose())) < 0 ? -1 : 1;
  const Eigen::Vector3d& s = svd.singularValues();
  const Matrix3x3 factor = from_eigen(u * Eigen::Vector3d(1, 1, sign).asDiagonal() * v.transpose());

  NearestRotation nearest;
  nearest.rotation = Rotation(UnitQuaternion::of_matrix(factor));
  nearest.distance = frobenius_norm(c_ij - nearest.rotation.matrix());
  // The rotation is unique while s₂ + sign s₃ > 0: what a turn between the last two directions would cost.
  nearest.unique = s(1) + sign * s(2) > tolerance::dependent_rows * s(0);
  return nearest;
}

}  // namespace linkwright
