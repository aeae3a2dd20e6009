#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/algebra/vector3.hpp"
#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/mechanism/body_rates.hpp"
#include "linkwright/mechanism/drive_table.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar_check.hpp"
#include "linkwright/mechanism/six_bar_motion.hpp"

namespace linkwright {

/// A driven linkage of any kind at one place of its travel. Angles in radians.
struct TravelState {
  double turn = 0;  ///< of the driver from position 1, positive in the sense of travel
  /// Of Travel::linkage, as many as that has: points of the plane z = 0, about a centre unit vectors.
  std::array<Vector3, SixBar::joint_count> hinges{};
  Pose body;                ///< the moving frame; its angle without jumps from state to state. About a centre: not set
  UnitQuaternion attitude;  ///< about a centre: of the coupler, from position 1
  double coupler_turn = 0, output_turn = 0;  ///< from position 1; of a six-bar of bodies 2 and 3
  double transmission_angle = 0;
  double velocity_ratio = 0;        ///< dψ/dφ of output by input; 0 at a dead point, and of six-bars
  double mechanical_advantage = 0;  ///< |dφ/dψ|; 0 at a dead point, where unbounded, and of six-bars
};

/// The whole travel of a driven linkage in the assembly of position 1: from dead point to dead point, or a full turn.
struct Travel {
  HingedBodies linkage;
  std::vector<TravelState> states;     ///< as they are passed
  std::vector<int> state_of_position;  ///< −1 where the drive does not get there
  std::vector<double> dead_points;     ///< turns, ascending; of six-bars none
  bool full_turn = false;              ///< first and last state are the same place
  bool starts_dead = false, ends_dead = false;

  [[nodiscard]] bool reaches_all_positions() const;
};

/// Four hinges in the order input fixed, input moving, output moving, output fixed.
[[nodiscard]] HingedBodies hinged_four_bar(bool spherical);

/// `poses`: what the drive table was made of. Empty where there is no linkage.
[[nodiscard]] Travel travel_of(const PoseVisits& visits, std::span<const PrescribedPose> poses);
/// Of a six-bar as it was driven in one sense (+1 counter-clockwise).
[[nodiscard]] Travel travel_of(const SixBar& six_bar, std::span<const PrescribedPose> poses, const SixBarCheck& check,
                               int sense);
/// Of all that a six-bar can do; its driver turns counter-clockwise.
[[nodiscard]] Travel travel_of(const SixBar& six_bar, std::span<const PrescribedPose> poses,
                               const SixBarMotion& motion);

/// Where a point of the body in the plane comes, by state: `traced` as it lies in position 1.
[[nodiscard]] std::vector<Point> path_of(const Travel& travel, Point traced);

/// By state how the bodies move while the driver turns as it travels, by one radian per unit of time: to each moving
/// body its angular velocity and acceleration (about a centre: of one without a hinge on the ground their magnitudes),
/// then of the plane velocity and acceleration, x and y, of the moving frame's origin, which `guided` carries. Nothing
/// at a dead point.
[[nodiscard]] std::vector<std::optional<std::vector<double>>> rates_of(const Travel& travel, int guided);

}  // namespace linkwright
