#pragma once

#include <span>
#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/six_bar_check.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"

namespace linkwright {

/// A six-bar at one place of its travel, and how well it is driven there.
struct SixBarMotionState {
  SixBarState place;
  double sine = 0;  ///< SixBarTransmission::sine
};

/// What a six-bar does when body 1 turns, in the assembly of position 1.
struct SixBarMotion {
  std::vector<SixBarMotionState> states;  ///< by rising turn of the driver (counter-clockwise from position 1)
  bool full_turn = false;                 ///< the driver turns fully: states go from 0 to 2π
  bool dyadic = false;                    ///< SixBarTransmission::dyadic
  double min_sine = 0;                    ///< over the motion, between the states as well; 0 without any
};

/// From dead point to dead point, or one full turn, in steps of the driver of at most `step` radians; the states where
/// the guided body meets one of `poses` (the first being that of position 1) are among them, and marked.
[[nodiscard]] SixBarMotion six_bar_motion(const SixBar& six_bar, std::span<const PrescribedPose> poses, double step);

/// The same motion with a state for each pose that it does not meet but passes by no more than a tenth of the longest
/// link from, in the distances of the guided body's hinges: where it comes nearest.
[[nodiscard]] SixBarMotion with_nearest_states(const SixBar& six_bar, std::span<const PrescribedPose> poses,
                                               SixBarMotion motion);

/// The part of the motion that meets all poses in their order, from the first to the last, by the shorter way where
/// both senses do; as the driver travels, so that its turn may fall. Empty where there is no such part.
[[nodiscard]] SixBarMotion travel_through(const SixBar& six_bar, std::span<const PrescribedPose> poses, double step);

/// The turns of the bodies that put the hinges there, distances within bodies being kept.
[[nodiscard]] SixBarTurns turns_of(const SixBar& six_bar, const std::array<Point, SixBar::joint_count>& joints);

}  // namespace linkwright
