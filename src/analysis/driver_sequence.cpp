#include "linkwright/analysis/driver_sequence.hpp"

namespace linkwright {

DriverSequence driver_sequence(Point center, Point circle, std::span<const PrescribedPose> poses,
                               bool respect_direction) {
  const Pose& first = poses.front().pose;
  const Point first_arm = circle - center;
  DriverSequence order{true, true, 0};
  double turned_ccw = 0;
  for (const PrescribedPose& pose : poses) {
    const Point moved = displaced(circle, first, pose.pose), arm = moved - center;
    if (&pose != &poses.front()) {
      const double angle = wrap_positive(std::arg(arm * std::conj(first_arm)));
      // Strictly forward, and clockwise turns are what is left of a full turn.
      order.ccw = order.ccw && angle > turned_ccw;
      order.cw = order.cw && angle > 0 && (turned_ccw == 0 || angle < turned_ccw);
      turned_ccw = angle;
    }
    if (respect_direction && !pose.derivatives.empty()) {
      const PoseDerivative& d = pose.derivatives.front();
      const Point velocity = d.origin + Point{0, d.angle} * (moved - pose.pose.origin);
      const double rate = cross(arm, velocity);
      order.ccw = order.ccw && rate > 0;
      order.cw = order.cw && rate < 0;
    }
  }
  order.sweep_ccw = turned_ccw;
  return order;
}

}  // namespace linkwright
