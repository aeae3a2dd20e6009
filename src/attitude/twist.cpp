#include "linkwright/attitude/twist.hpp"

#include <cmath>

#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

Error not_finite_twist() { return {"not_finite", "twist", "a number is missing or infinite: give finite numbers"}; }

InstantaneousScrew without_turning(Vector3 velocity) {
  InstantaneousScrew screw;
  if (velocity == Vector3{}) return screw;
  screw.kind = TwistKind::translation;
  screw.direction = normalized(velocity);
  screw.slide_rate = norm(velocity);
  return screw;
}

}  // namespace

std::optional<double> InstantaneousScrew::pitch() const {
  if (rate == 0) return std::nullopt;
  return slide_rate / rate;
}

Result<InstantaneousScrew> instantaneous_screw(const Twist& twist) {
  const Vector3 v = twist.velocity;
  if (!is_finite(twist.angular) || !is_finite(v)) return not_finite_twist();
  if (twist.angular == Vector3{}) return without_turning(v);

  InstantaneousScrew screw;
  const Vector3 p = screw.direction = normalized(twist.angular);
  screw.rate = norm(twist.angular);
  const double slide = dot(p, v);
  const bool slides = std::fabs(slide) > tolerance::no_slide * norm(v);
  screw.kind = slides ? TwistKind::screw : TwistKind::rotation;
  screw.slide_rate = slides ? slide : 0;
  screw.point = cross(p, v) / screw.rate;
  if (!is_finite(screw.point)) {
    return Error{"axis_too_far", "twist",
                 "the axis lies farther away than numbers reach: take a larger unit of length, or no rotation"};
  }
  return screw;
}

Result<Twist> twist_of(Vector3 direction, Vector3 point, double rate, double slide_rate) {
  if (!is_finite(direction) || !is_finite(point) || !std::isfinite(rate) || !std::isfinite(slide_rate))
    return not_finite_twist();
  const Result<AxisAngle> axis = AxisAngle::of(direction, rate);
  if (!axis) return axis.errors();
  const Twist twist = Twist::of_point(rate * axis->axis(), slide_rate * axis->axis(), point);
  if (!is_finite(twist.velocity)) return not_finite_twist();
  return twist;
}

Result<Twist> twist_of(const InstantaneousScrew& screw) {
  return twist_of(screw.direction, screw.point, screw.rate, screw.slide_rate);
}

}  // namespace linkwright
