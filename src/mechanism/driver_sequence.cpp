#include "linkwright/mechanism/driver_sequence.hpp"

namespace linkwright {

// Strictly forward, and clockwise turns are what is left of a full turn.
void DriverSequenceBuilder::meet(double angle) {
  const double turned_ccw = sequence_.sweep_ccw;
  if (!is_first_) {
    sequence_.ccw = sequence_.ccw && angle > turned_ccw;
    sequence_.cw = sequence_.cw && angle > 0 && (turned_ccw == 0 || angle < turned_ccw);
  }
  sequence_.sweep_ccw = angle;
  is_first_ = false;
}

void DriverSequenceBuilder::pass(double rate) {
  sequence_.ccw = sequence_.ccw && rate > 0;
  sequence_.cw = sequence_.cw && rate < 0;
}

DriverSequence driver_sequence(Point center, Point circle, std::span<const PrescribedPose> poses,
                               bool respect_direction) {
  const Pose& first = poses.front().pose;
  const Point first_arm = circle - center;
  DriverSequenceBuilder order;
  for (const PrescribedPose& pose : poses) {
    const Point moved = displaced(circle, first, pose.pose), arm = moved - center;
    order.meet(&pose == &poses.front() ? 0 : wrap_positive(std::arg(arm * std::conj(first_arm))));
    if (respect_direction && !pose.derivatives.empty()) {
      const PoseDerivative& d = pose.derivatives.front();
      order.pass(cross(arm, d.origin + Point{0, d.angle} * (moved - pose.pose.origin)));
    }
  }
  return order.sequence();
}

}  // namespace linkwright
