#pragma once

#include <span>
#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"

namespace linkwright {

/// A six-bar at one place of its travel.
struct SixBarState {
  double turn = 0;  ///< of the driver from position 1, radians, counter-clockwise
  std::array<Point, SixBar::joint_count> joints{};
  Pose body;        ///< the moving frame, its angle without jumps from state to state
  int pose = -1;    ///< the pose that is met there, or that the body comes nearest to; −1: none
  BodyError error;  ///< how far it is from that pose
};

struct SixBarCheckOptions {
  double step = 0.02;            ///< of the driver, radians, at most; steps are shorter where a hinge moves fast
  double pose_tolerance = 1e-6;  ///< largest pose error that counts as met, over the longest link
  bool full_travel = false;      ///< drives on when all poses are met, to a dead point or a whole turn
};

/// What happened on the way.
struct SixBarCheck {
  std::vector<int> visited;  ///< poses as they were met after the first, which is not listed
  bool stopped = false;      ///< the driver came to a dead point, or could not be followed
  double worst_length = 0;   ///< largest relative change of a distance between two hinges of a body
  double worst_pose = 0;     ///< largest distance of the guided body's hinges from where a visited pose wants them,
                             ///< as a share of the longest link
  std::vector<SixBarState> states;  ///< at each step, by the way, the poses met among them
};

/// Drives a six-bar by body 1, counter-clockwise (`sense` +1) or clockwise (−1), from position 1 for a whole turn,
/// until it comes to a dead point or, unless told to go to the end, has met all poses (the first being that of
/// position 1): another way than drive_six_bar. It knows the hinges' coordinates and the shapes of the bodies and
/// nothing of loops, turns or dyads: a step of the driver's angle, and Newton's method on the distances.
[[nodiscard]] SixBarCheck check_by_driving(const SixBar& six_bar, std::span<const PrescribedPose> poses, int sense,
                                           const SixBarCheckOptions& options = {});

}  // namespace linkwright
