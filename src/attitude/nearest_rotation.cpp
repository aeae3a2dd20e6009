#include "nearest_rotation.hpp"

#include <cmath>

#include "algebra/dense.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

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
  const auto [u, v, s] = singular_values(scaled);
  const double sign = determinant(u * transposed(v)) < 0 ? -1 : 1;
  const Matrix3x3 factor = Matrix3x3::of_columns(u.column(0), u.column(1), sign * u.column(2)) * transposed(v);

  NearestRotation nearest;
  nearest.rotation = Rotation(UnitQuaternion::of_matrix(factor));
  nearest.distance = frobenius_norm(c_ij - nearest.rotation.matrix());
  // The rotation is unique while s₂ + sign s₃ > 0: what a turn between the last two directions would cost.
  nearest.unique = s[1] + sign * s[2] > tolerance::dependent_rows * s[0];
  return nearest;
}

}  // namespace linkwright
