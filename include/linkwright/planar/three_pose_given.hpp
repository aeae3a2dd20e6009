#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/four_bar.hpp"

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

/// A pivot of a grounded link, fixed frame; a moving one as it lies in position 1. Its link has one dyad.
struct GivenPivot {
  PivotKind kind = PivotKind::ground;
  Point point{};  ///< user's unit
  friend bool operator==(const GivenPivot&, const GivenPivot&) = default;
};

/// One pivot of each grounded link, which makes one linkage, or of one of them alone: the other link's pivot of the
/// same kind is left open. At least one is given.
struct GivenPivots {
  std::optional<GivenPivot> input, output;
  friend bool operator==(const GivenPivots&, const GivenPivots&) = default;
};

/// Lines on which both links have their ground pivots, their moving pivots (in position 1), or each its own of both.
/// At least one is given.
struct PivotLines {
  std::optional<LineAtAngle> ground, moving;  ///< user's unit
  friend bool operator==(const PivotLines&, const PivotLines&) = default;
};

/// What a three-position task gives beside its poses (theory: docs/theory/three_poses.md).
using ThreePoseGiven = std::variant<SideLengths, SideAngle, InstantCenter, GivenPivots, PivotLines>;

/// The caller's mistakes: lengths that are not positive or too large, numbers that are not finite, both pivots at one
/// place. Places are `task.given.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const ThreePoseGiven& given);

}  // namespace linkwright
