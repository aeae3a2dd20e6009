#include "linkwright/infinitesimal/line_contact.hpp"

#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {

LineContact contact_with_line(const MotionSeries& motion, Point point, Point direction) {
  const auto path = motion.path_of(point);
  RealSeries<motion_order> along, off;
  for (std::size_t k = 1; k <= motion.order; ++k) {
    along.c[k] = dot(direction, path.c[k]);
    off.c[k] = cross(direction, path.c[k]);
  }
  LineContact contact;
  const double speed = std::hypot(along.c[1], off.c[1]);
  const double arm = std::abs(point - motion.path.c[0]);
  if (!(speed > tolerance::vanishing_motion * (std::abs(motion.path.c[1]) + arm * std::abs(motion.turn.c[1]))))
    return contact;
  if (!(std::abs(along.c[1]) > tolerance::vanishing_deviation * speed)) {
    contact.points = 1;
    return contact;
  }
  const RealSeries<motion_order> time = inverse(along);
  contact.deviation = composed(off, time).c;
  // What the terms of a coefficient are without their signs: its rounding is a share of that, in any unit.
  const auto turned = rotation(motion.turn);
  RealSeries<motion_order> travel, delay;
  for (std::size_t k = 1; k <= motion.order; ++k) {
    travel.c[k] = std::abs(motion.path.c[k]) + arm * std::abs(turned.c[k]);
    delay.c[k] = std::abs(time.c[k]);
  }
  const auto terms = composed(travel, delay).c;
  contact.points = static_cast<int>(motion.order) + 1;
  for (std::size_t k = 1; k <= motion.order; ++k)
    if (std::abs(contact.deviation[k]) > tolerance::vanishing_deviation * terms[k]) {
      contact.points = static_cast<int>(k);
      break;
    }
  return contact;
}

}  // namespace linkwright
