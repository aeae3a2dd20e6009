#pragma once

#include <optional>

#include "linkwright/attitude/displacement.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {

enum class ScrewKind : unsigned char {
  identity,          ///< nothing moves; every line is an axis
  pure_translation,  ///< no rotation; every line of the direction is an axis
  half_turn,         ///< a turn by π: the axis is one line, but which way it points is free
  general,           ///< one axis, pointing so that the angle is positive
};

/// A displacement as a turn about a line and a slide along it (Chasles, Note sur les propriétés générales du système de
/// deux corps semblables entr'eux, 1830; Han Jianyou et al., Modern Synthesis Theory and Methods of Linkages, 2013,
/// section 1.3.2). All vectors in the frame in which the displacement is given.
struct Screw {
  ScrewKind kind = ScrewKind::identity;
  Vector3 direction{0, 0, 1};  ///< unit vector along the axis; along z for the identity, where it is undefined
  Vector3 point{};             ///< point of the axis nearest the origin; the origin itself where every line is an axis
  double angle = 0;            ///< about the direction, radians, in [0, π]
  double translation = 0;      ///< along the direction, the user's length; not negative for a pure translation

  /// Translation per radian; infinite, so nothing, for a pure translation and for the identity.
  [[nodiscard]] std::optional<double> pitch() const;
};

/// The screw of a displacement: direction p and angle θ of the rotation, translation s = p·d, point
/// ½(d⊥ + cot(θ/2) p × d) with d⊥ = d − s p.
///
/// Accurate to rounding for every angle up to π. For small angles the point is far off and the data do not hold more:
/// with the matrix exact to u = 1e-16 the point is uncertain by u |d| / θ², unless its small elements are relatively
/// exact as those of Rotation::about_axis() are. A turn by at most `no_turn` counts as none, since products of matrices
/// leave as much behind; pass 0 where small turns are exact. Errors: `not_finite`.
[[nodiscard]] Result<Screw> screw_of(const Displacement& displacement, double no_turn = tolerance::no_turn);

/// The displacement by a turn about the line through `point` (any of its points) along `direction` (any length but
/// zero) by `angle`, radians, any number of turns, with a translation along it: d = (E − A) point + translation p. For
/// a pure translation angle 0. Errors: `not_finite`, `zero_axis`.
[[nodiscard]] Result<Displacement> screw_displacement(Vector3 direction, Vector3 point, double angle,
                                                      double translation);

/// As above by the screw's own parameters; its kind is ignored.
[[nodiscard]] Result<Displacement> screw_displacement(const Screw& screw);

}  // namespace linkwright
