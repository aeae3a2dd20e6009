#include "linkwright/attitude/rotation.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/attitude/nearest_rotation.hpp"
#include "linkwright/attitude/rotation_properties.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

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

}  // namespace linkwright
