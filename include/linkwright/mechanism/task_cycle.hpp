#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// A driven four-bar and its body at one place of its motion cycle. Angles in radians, without jumps from state to
/// state, directions counter-clockwise from the x axis of the fixed frame.
struct CycleState {
  double turn = 0;  ///< of the input from pose 0, counter-clockwise
  FourBar four_bar;
  double input_angle = 0, coupler_angle = 0, output_angle = 0;  ///< from fixed to moving pivot, input's to output's
  Pose body;
  double transmission_angle = 0;
  std::optional<AngleRates> rates;  ///< nothing at a dead point
  int pose = -1;                    ///< the pose that the body comes nearest to here; −1: none
  BodyError error;                  ///< how far it is from that pose
};

/// The motion cycle on the circuit of pose 0, from pose 0 on in the sense of travel (pose_visits) until it is there
/// again: a crank's whole turn; of all others the way to the dead point, in the other assembly to the opposite dead
/// point, and back. A state at each multiple of `step` of the input's turn, at each dead point, and once for each
/// pose on the circuit, where the moving pivots come nearest to where the pose wants them; always of the linkage as it
/// moves, its links as long as in pose 0. `poses`: as in find_defects, at least one. Empty for links
/// that are none or cannot be assembled.
[[nodiscard]] std::vector<CycleState> task_cycle(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                                 double step);

}  // namespace linkwright
