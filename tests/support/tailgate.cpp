#include "support/tailgate.hpp"

#include "linkwright/core/angle.hpp"

namespace linkwright::testing {

MotionTask tailgate_task() {
  MotionTask task;
  for (const Pose& pose : {Pose{{0, 0}, 0}, Pose{{-125, 75}, radians(-25)}, Pose{{-220, 220}, radians(-52)},
                           Pose{{-220, 450}, radians(-82)}})
    task.poses.push_back({pose, {}});
  return task;
}

Requirements tailgate_requirements() {
  Requirements wanted;
  wanted.min_transmission_angle = radians(30);
  wanted.max_link_ratio = 8;
  wanted.max_length = 450;
  wanted.ground_pivots_within = Box{70, 430, 270, 410};
  wanted.moving_pivots_within = Box{-60, 200, 90, 380};
  return wanted;
}

}  // namespace linkwright::testing
