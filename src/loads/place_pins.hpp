#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "loads/hand_study.hpp"

namespace linkwright {

/// What the pins lose, to first order, at the stations of a travel in one case under a spring between the ground and
/// the body. The forces of frictionless pins, the hand's among what makes them, are linear in the force of the spring
/// and in its moment about the origin of the moving frame.
class PlacePins {
 public:
  /// `loads`: without the spring, with pins.
  PlacePins(const Loads& loads, const LoadCase& of, const FourBar& first, const Pose& body);

  void add(const LoadedPlace& place, Point body_origin);

  /// A spring's force on the body, N, and what it grows by in a unit of its charge; its moment about the body's origin
  /// for 1 N.
  struct Pushing {
    Point along{};  ///< a unit vector
    double lever = 0;
    double force = 0, by_charge = 0;
  };
  struct Loss {
    double force = 0, by_charge = 0;  ///< of the hand, N
  };
  /// `sense`: +1 opening, −1 closing.
  [[nodiscard]] Loss loss(std::size_t station, int sense, const Pushing& spring) const;

 private:
  struct Station {
    std::array<JointForces, 2> without;          ///< opening, closing
    JointForces by_x, by_y, by_moment;           ///< of 1 N and 1 N times the unit of length
    std::array<double, four_bar_joints> weight;  ///< force of the hand for 1 N at the joint
  };

  BoundLoads bound_;
  double friction_circle_ = 0;
  std::vector<Station> stations_;
};

}  // namespace linkwright
