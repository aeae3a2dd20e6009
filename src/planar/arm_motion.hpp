#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "arm_reach.hpp"
#include "five_conditions.hpp"
#include "linkwright/algebra/point.hpp"

namespace linkwright {

/// A place of the point and its first, second, … derivatives by any parameter.
using PathJet = std::vector<Point>;

/// A place of a path, the first of which is the origin of the frame.
struct PathPlace {
  enum class Angle { none, of_body, of_link };

  PathJet jet;
  Angle known = Angle::none;   ///< what is known of the arm there
  std::vector<double> angles;  ///< it, from any datum, and as many derivatives as the place has; radians
};

/// An arm as it stands at a place of a map.
struct PlacedArm {
  Point pivot{};  ///< the fixed one
  Arm lengths;
  Point at_zero{};  ///< where the path tells angles: the body's part, or the link, at the angle 0
};

/// How an arm takes the point through the places of a path.
struct ArmMotion {
  /// Derivatives of the angles of link and body at a place, as many as the path has there.
  struct Rates {
    std::vector<double> link, body;
  };

  std::array<Point, ArmElbows::most_points> link;  ///< by place: from the fixed pivot to the moving one
  std::array<Point, ArmElbows::most_points> turn;  ///< e^{iθ} of the body from the first place on
  std::vector<Rates> rates;                        ///< by place; empty where the path has no derivatives
};

/// Of an arm that reaches all places. `elbows`: at those, in their order, where no angle is known. The derivatives of
/// the point tell those of both angles, but where the arm lies stretched they are not finite (docs/theory/path.md).
[[nodiscard]] ArmMotion arm_motion(const PlacedArm& arm, std::span<const PathPlace> path, const ArmElbows& elbows,
                                   const ElbowPattern& pattern);

/// What the body's motion asks of its dyads: a row to each position but the first, derivatives after their place. At
/// most five positions; rows beyond are 0.
[[nodiscard]] ConditionRows condition_rows(std::span<const PathPlace> path, const ArmMotion& motion);

}  // namespace linkwright
