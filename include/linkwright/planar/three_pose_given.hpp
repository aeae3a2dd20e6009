#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// Lengths of the grounded links (fixed to moving pivot), user's unit. Without `output` the one length is the input's.
struct SideLengths {
  double input = 0;
  std::optional<double> output;
  friend bool operator==(const SideLengths&, const SideLengths&) = default;
};

/// Angle in position 1 from the input to the output link, both directed from the fixed to the moving pivot;
/// radians, counter-clockwise.
struct SideAngle {
  double angle = 0;
  bool directed = true;                ///< false: the angle of the two lines, modulo π
  std::optional<double> input_length;  ///< user's unit
  friend bool operator==(const SideAngle&, const SideAngle&) = default;
};

/// Centre of the body's instantaneous rotation in position 1.
struct InstantCenter {
  Point point{};             ///< user's unit; at infinity: the direction in which it lies, of any length but 0
  bool at_infinity = false;  ///< the body starts with a translation, across that direction
  friend bool operator==(const InstantCenter&, const InstantCenter&) = default;
};

/// What a three-position task gives beside its poses (theory: docs/theory/three_poses.md).
using ThreePoseGiven = std::variant<SideLengths, SideAngle, InstantCenter>;

/// The caller's mistakes: lengths that are not positive or too large, numbers that are not finite. Places are
/// `task.given.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const ThreePoseGiven& given);

}  // namespace linkwright
