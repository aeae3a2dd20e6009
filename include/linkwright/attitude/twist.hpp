#pragma once

#include <optional>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/result.hpp"

namespace linkwright {

/// The velocities of a moving body at one instant, by coordinates in one frame: radians and lengths per unit of time.
struct Twist {
  Vector3 angular{};   ///< ω
  Vector3 velocity{};  ///< of the point of the body that lies at the origin

  /// The twist of a body that turns by ω while its point at r moves by v: the origin moves by v − ω × r.
  [[nodiscard]] static constexpr Twist of_point(Vector3 angular, Vector3 velocity, Vector3 r) {
    return {angular, velocity - cross(angular, r)};
  }

  /// v + ω × r: the velocity of the point of the body that lies at r.
  [[nodiscard]] constexpr Vector3 velocity_at(Vector3 r) const { return velocity + cross(angular, r); }

  friend constexpr bool operator==(const Twist&, const Twist&) = default;
};

enum class TwistKind : unsigned char {
  rest,         ///< nothing moves; every line is an axis
  translation,  ///< no rotation; every line of the direction is an axis
  rotation,     ///< the points of the axis are at rest: the pitch is 0
  screw,        ///< the points of the axis move along it
};

/// A twist as a turning about a line and a sliding along it: the instantaneous screw (Mozzi 1763, Chasles 1830; Han
/// Jianyou et al., Modern Synthesis Theory and Methods of Linkages, 2013, section 1.3). It is the limit of the finite
/// screw (screw.hpp) of two poses dt apart: angle and translation, each divided by dt, become the two rates.
struct InstantaneousScrew {
  TwistKind kind = TwistKind::rest;
  Vector3 direction{0, 0, 1};  ///< unit vector along the axis; along z at rest, where it is undefined
  Vector3 point{};             ///< of the axis, nearest the origin; the origin itself where every line is an axis
  double rate = 0;             ///< |ω|, radians per unit of time, not negative
  double slide_rate = 0;       ///< along the direction, lengths per unit of time; not negative for a translation

  /// h = ω·v/ω², length per radian; infinite, so nothing, for a translation and at rest.
  [[nodiscard]] std::optional<double> pitch() const;
};

/// Direction ω/|ω|, rate |ω|, slide rate p·v, point ω × v / ω². A slide rate of at most tolerance::no_slide of the
/// origin's speed is what rounding leaves of none, and 0. Errors: `not_finite`, `axis_too_far`.
[[nodiscard]] Result<InstantaneousScrew> instantaneous_screw(const Twist& twist);

/// The twist of a turning at `rate`, of any sign, about the line through `point` (any of its points) along `direction`
/// (any length but zero) with a sliding along it: ω = rate p, v = slide_rate p − ω × point. Errors: `not_finite`,
/// `zero_axis`.
[[nodiscard]] Result<Twist> twist_of(Vector3 direction, Vector3 point, double rate, double slide_rate);

/// As above by the screw's own parameters; its kind is ignored.
[[nodiscard]] Result<Twist> twist_of(const InstantaneousScrew& screw);

}  // namespace linkwright
