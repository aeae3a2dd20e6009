#include "linkwright/attitude/axis_angle.hpp"

#include <cmath>

namespace linkwright {

Result<AxisAngle> AxisAngle::of(Vector3 axis, double angle) {
  if (!is_finite(axis)) return Error{"not_finite", "axis", "not a number or infinite: give three finite numbers"};
  if (!std::isfinite(angle)) return Error{"not_finite", "angle", "not a number or infinite: give a finite angle"};
  if (axis == Vector3{})
    return Error{"zero_axis", "axis",
                 "the axis is the null vector, which has no direction: give it any length but zero"};
  AxisAngle turn;
  turn.axis_ = normalized(axis);
  turn.angle_ = angle;
  turn.axis_defined_ = true;
  return turn;
}

AxisAngle AxisAngle::of(const UnitQuaternion& q_ij) {
  const UnitQuaternion q = q_ij.canonical();
  AxisAngle turn;
  turn.axis_defined_ = q.v() != Vector3{};
  if (!turn.axis_defined_) return turn;
  turn.axis_ = normalized(q.v());
  turn.angle_ = 2 * std::atan2(norm(q.v()), q.w());
  return turn;
}

AxisAngle AxisAngle::inverse() const {
  AxisAngle back = *this;
  back.angle_ = -angle_;
  return back;
}

UnitQuaternion AxisAngle::quaternion() const {
  return *UnitQuaternion::of(std::cos(angle_ / 2), std::sin(angle_ / 2) * axis_);
}

}  // namespace linkwright
