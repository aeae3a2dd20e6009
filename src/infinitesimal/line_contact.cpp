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
  contact.deviation = composed(off, inverse(along)).c;
  // As long as the point moves along the line, e vanishes by s to the order to which it does by the motion's parameter,
  // in which rounding is a share of what the terms are without their signs, in any unit and next to a cusp, too.
  const auto turned = rotation(motion.turn);
  contact.points = static_cast<int>(motion.order) + 1;
  for (std::size_t k = 1; k <= motion.order; ++k)
    if (std::abs(off.c[k]) >
        tolerance::vanishing_deviation * (std::abs(motion.path.c[k]) + arm * std::abs(turned.c[k]))) {
      contact.points = static_cast<int>(k);
      break;
    }
  return contact;
}

}  // namespace linkwright
