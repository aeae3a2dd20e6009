#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose_visits.hpp"
#include "linkwright/mechanism/position.hpp"

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

/// Where a transmission angle is largest. Radians.
struct TransmissionPeak {
  double angle = 0, input_angle = 0;
};

/// Over a range of the input: exact, π/2 where coupler and output link come to stand at right angles, else where the
/// diagonal has an extreme or the range ends. 0 for links that are none.
[[nodiscard]] TransmissionPeak largest_transmission_angle(const LinkLengths& lengths, const AngleRange& range);

/// Least and largest ratio of the angular velocities of output and input.
struct RatioRange {
  double least = 0, most = 0;
};

/// Over the turn of a crank in one assembly; nothing where it passes a dead point, or the input is no crank.
[[nodiscard]] std::optional<RatioRange> output_rates_full_turn(const LinkLengths& lengths, Assembly assembly);

}  // namespace linkwright
