#pragma once

#include <span>
#include <vector>

#include "linkwright/analysis/pose_visits.hpp"

namespace linkwright {

/// A driven four-bar and its body at one place of the travel. Angles in radians.
struct DriveState {
  double turn = 0;                           ///< of the input from pose 0, positive in the sense of travel
  FourBar four_bar;                          ///< all four pivots, fixed frame
  Pose body;                                 ///< the moving frame; its angle without jumps from state to state
  double coupler_turn = 0, output_turn = 0;  ///< from pose 0, counter-clockwise, without jumps
  double transmission_angle = 0;
  double velocity_ratio = 0;        ///< dψ/dφ of output by input; 0 at a dead point
  double mechanical_advantage = 0;  ///< output torque over input torque |dφ/dψ|; 0 at a dead point and where unbounded
};

/// The whole travel of a driven four-bar in the assembly of pose 0.
struct DriveTable {
  std::vector<DriveState> states;  ///< by rising turn
  std::vector<int> state_of_pose;  ///< by pose; −1 where the drive does not get there
  bool full_turn = false;          ///< first and last state are the same place
};

/// `samples` ≥ 2 states evenly spaced in the input's turn, and the poses among them, the body there exactly as
/// prescribed (a state within a hundredth of a step of a pose gives way to it). Empty where `visits` is.
[[nodiscard]] DriveTable drive_table(const PoseVisits& visits, std::span<const PrescribedPose> poses, int samples);

}  // namespace linkwright
