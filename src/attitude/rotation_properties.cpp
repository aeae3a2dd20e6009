#include "linkwright/attitude/rotation_properties.hpp"

#include <cmath>

namespace linkwright {

double orthogonality_error(const Matrix3x3& a) { return frobenius_norm(transposed(a) * a - Matrix3x3::identity()); }

double cofactor_error(const Matrix3x3& a) { return frobenius_norm(a - cofactors(a)); }

bool is_rotation(const Matrix3x3& a, double most) {
  return is_finite(a) && orthogonality_error(a) <= most && determinant(a) > 0;
}

double cosine_by_trace(const Matrix3x3& a) { return (trace(a) - 1) / 2; }

EigenvalueOne eigenvalue_one(const Rotation& rotation) {
  const UnitQuaternion q = rotation.quaternion();
  EigenvalueOne result;
  const Matrix3x3 difference = q.matrix_minus_identity();
  result.determinant = determinant(difference);
  // Scaled to elements of order 1, so that the adjugate of tiny turns, of order θ², does not underflow.
  const double size = frobenius_norm(difference);
  result.axis_defined = size > 0;
  if (!result.axis_defined) return result;
  const Matrix3x3 adjugate = transposed(cofactors((1 / size) * difference));
  Vector3 longest;
  for (const Vector3& row : adjugate.row)
    if (dot(row, row) > dot(longest, longest)) longest = row;
  result.axis = normalized(dot(longest, q.v()) < 0 ? -longest : longest);
  result.residual = norm(rotation.apply(result.axis) - result.axis);
  return result;
}

}  // namespace linkwright
