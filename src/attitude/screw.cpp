#include "linkwright/attitude/screw.hpp"

#include <cmath>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

Error not_finite_screw() { return {"not_finite", "screw", "a number is missing or infinite: give finite numbers"}; }

/// No turn: along the translation, or nothing at all.
Screw sliding(Vector3 d) {
  Screw screw;
  if (d == Vector3{}) return screw;
  screw.kind = ScrewKind::pure_translation;
  screw.direction = normalized(d);
  screw.translation = norm(d);
  return screw;
}

}  // namespace

std::optional<double> Screw::pitch() const {
  if (angle == 0) return std::nullopt;
  return translation / angle;
}

Result<Screw> screw_of(const Displacement& displacement, double no_turn) {
  const Vector3 d = displacement.translation;
  if (!is_finite(d) || !is_finite(displacement.rotation.matrix())) return not_finite_screw();
  const UnitQuaternion q = displacement.rotation.quaternion();
  const double sine = norm(q.v());  // of half the angle
  const double angle = 2 * std::atan2(sine, q.w());
  if (!(angle > no_turn)) return sliding(d);

  Screw screw;
  const Vector3 p = screw.direction = normalized(q.v());
  screw.angle = angle;
  screw.translation = dot(p, d);
  // p × d is p × d⊥, and d⊥ = −p × (p × d) stays perpendicular where d and p almost agree.
  const Vector3 moment = cross(p, d);
  screw.point = 0.5 * ((q.w() / sine) * moment - cross(p, moment));
  if (!is_finite(screw.point))
    return Error{
        "axis_too_far", "screw",
        "the axis lies farther away than numbers reach: take a larger unit of length, or count so small a turn "
        "as none"};
  screw.kind = pi - angle <= no_turn ? ScrewKind::half_turn : ScrewKind::general;
  return screw;
}

Result<Displacement> screw_displacement(Vector3 direction, Vector3 point, double angle, double translation) {
  if (!is_finite(direction) || !is_finite(point) || !std::isfinite(angle) || !std::isfinite(translation))
    return not_finite_screw();
  const Result<AxisAngle> turn = AxisAngle::of(direction, angle);
  if (!turn) return turn.errors();
  const UnitQuaternion q = turn->quaternion();
  const Vector3 d = translation * turn->axis() - q.matrix_minus_identity() * point;
  if (!is_finite(d)) return not_finite_screw();
  return Displacement{Rotation(q), d};
}

Result<Displacement> screw_displacement(const Screw& screw) {
  return screw_displacement(screw.direction, screw.point, screw.angle, screw.translation);
}

}  // namespace linkwright
