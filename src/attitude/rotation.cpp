#include "linkwright/attitude/rotation.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "nearest_rotation.hpp"

namespace linkwright {
namespace {

/// "[[…], […], […]]".
std::string rows_text(const Matrix3x3& a) {
  // + 0.0 makes 0 of −0.
  const auto row = [](Vector3 r) { return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", r.x + 0.0, r.y + 0.0, r.z + 0.0); };
  return fmt::format("[{}, {}, {}]", row(a.row[0]), row(a.row[1]), row(a.row[2]));
}

/// "the nearest rotation, 0.01 away, is [[…], […], […]]".
std::string offer(const NearestRotation& nearest) {
  return fmt::format("{} rotation, {:.3g} away, is {}", nearest.unique ? "the nearest" : "a nearest", nearest.distance,
                     rows_text(nearest.rotation.matrix()));
}

Error not_orthogonal(double error, double det, const NearestRotation& nearest) {
  return {"not_orthogonal",
          "matrix",
          fmt::format("not a rotation: its columns are not orthonormal, AᵀA differs from the identity by {:.3g}{}; {}",
                      error, det < 0 ? ", and its determinant is negative" : "", offer(nearest)),
          {{"error", error},
           {"determinant", det},
           {"distance", nearest.distance},
           {"nearest", rows_text(nearest.rotation.matrix())}}};
}

Error reflection(const NearestRotation& nearest) {
  return {
      "reflection",
      "matrix",
      fmt::format("not a rotation but a reflection: its determinant is −1, so one of the frames is left-handed; turn "
                  "the sign of one axis, or take another: {}",
                  offer(nearest)),
      {{"distance", nearest.distance}, {"nearest", rows_text(nearest.rotation.matrix())}}};
}

}  // namespace

Result<Rotation> Rotation::from_matrix(const Matrix3x3& c_ij, double largest_error) {
  const Result<NearestRotation> nearest = nearest_rotation(c_ij);
  if (!nearest) return nearest.errors();
  const double error = orthogonality_error(c_ij);
  if (!(error <= largest_error)) return not_orthogonal(error, determinant(c_ij), *nearest);
  if (determinant(c_ij) < 0) return reflection(*nearest);
  // What is orthogonal to rounding stays as it is: small elements of small turns keep their relative accuracy.
  return error <= tolerance::orthogonal_to_rounding ? Rotation(c_ij) : nearest->rotation;
}

Result<Rotation> Rotation::from_triads(const Triad& axes_of_i, const Triad& axes_of_j) {
  const Result<Rotation> i = from_matrix(Matrix3x3::of_columns(axes_of_i[0], axes_of_i[1], axes_of_i[2]));
  const Result<Rotation> j = from_matrix(Matrix3x3::of_columns(axes_of_j[0], axes_of_j[1], axes_of_j[2]));
  std::vector<Error> errors;
  for (const auto& [triad, name] : {std::pair{&i, "axes_of_i"}, std::pair{&j, "axes_of_j"}}) {
    if (triad->ok()) continue;
    for (Error error : triad->errors()) {
      error.place = name;
      errors.push_back(std::move(error));
    }
  }
  if (!errors.empty()) return errors;
  return i->inverse() * *j;
}

Rotation Rotation::about(Axis axis, double angle) {
  require(std::isfinite(angle), "an angle is a number");
  const double c = std::cos(angle), s = std::sin(angle);
  switch (axis) {
    case Axis::x:
      return Rotation(Matrix3x3{{{{1, 0, 0}, {0, c, -s}, {0, s, c}}}});
    case Axis::y:
      return Rotation(Matrix3x3{{{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}}});
    case Axis::z:
      break;
  }
  return Rotation(Matrix3x3{{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}});
}

Result<Rotation> Rotation::about_axis(Vector3 axis, double angle) {
  const Result<AxisAngle> turn = AxisAngle::of(axis, angle);
  if (!turn) return turn.errors();
  return turn->rotation();
}

Rotation Rotation::renormalized() const {
  const Result<NearestRotation> nearest = nearest_rotation(c_ij_);
  return nearest->rotation;
}

double angle_between(const Rotation& a, const Rotation& b) { return angle_between(a.quaternion(), b.quaternion()); }

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
