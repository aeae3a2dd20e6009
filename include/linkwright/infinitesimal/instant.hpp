#pragma once

#include <optional>
#include <variant>

#include "linkwright/algebra/homogeneous.hpp"
#include "linkwright/infinitesimal/motion_series.hpp"

namespace linkwright {

struct Circle {
  Point center{};
  double radius = 0;
};
struct StraightLine {
  Point point{};
  Point direction{};  ///< unit vector
};
/// A circle, or what it has become where its centre is at infinity.
using CircleOrLine = std::variant<Circle, StraightLine>;

/// Invariants of the fourth order, by the body's own turn (Bottema and Roth, Theoretical Kinematics, ch. VIII).
struct FourthOrderInvariants {
  double a4 = 0, b4 = 0;
};

/// A body that turns, in its canonical frame: origin at the pole P, x along the pole tangent, y along the pole normal
/// towards the inflection pole. By the body's turn φ its motion is X = x cos φ − y sin φ + a(φ), Y = x sin φ + y cos φ
/// + b(φ) with a = b = a′ = b′ = a″ = 0, b″ = D; a3 … b4 are the derivatives that follow.
struct TurningInstant {
  Point pole{};
  Point tangent{};      ///< unit vector along the pole tangent, against which the pole travels as the body turns
  double diameter = 0;  ///< D of the inflection circle, positive
  double a3 = 0, b3 = 0;
  std::optional<FourthOrderInvariants> fourth;  ///< nothing where the motion is known to the third order only

  /// Of the cubic of stationary curvature, (x² + y²)(m x + n y) = x y: (a3 + 3D) / 3D² and b3 / 3D².
  [[nodiscard]] double m() const { return (a3 + 3 * diameter) / (3 * diameter * diameter); }
  [[nodiscard]] double n() const { return b3 / (3 * diameter * diameter); }

  [[nodiscard]] Point to_fixed(Point canonical) const { return pole + tangent * canonical; }
  [[nodiscard]] Point to_canonical(Point fixed) const { return std::conj(tangent) * (fixed - pole); }

  [[nodiscard]] Point inflection_pole() const { return to_fixed({0, diameter}); }
  /// Of the points whose paths have no curvature now: x² + y² = D y.
  [[nodiscard]] Circle inflection_circle() const { return {to_fixed({0, diameter / 2}), diameter / 2}; }
  /// Of the points that are centres of curvature of lines of the body, its mirror image in the tangent.
  [[nodiscard]] Circle return_circle() const { return {to_fixed({0, -diameter / 2}), diameter / 2}; }
};

/// A body that turns about a point which stays where it is to the second order (a grounded link does, and a coupler
/// that lies as one): all paths are circles about it, and no point inflects.
struct PivotingInstant {
  Point pole{};
};

/// x y = product with the origin at `center`, axes in a given direction and to its left.
struct EquilateralHyperbola {
  Point center{};
  double product = 0;
};

/// A body that does not turn now: the pole is at infinity, normal to the velocity.
struct TranslatingInstant {
  Point velocity{};  ///< unit vector
  /// κ of the paths, over the coordinate along the velocity: κ = curvature + slope · ⟨velocity, point⟩.
  double curvature = 0, slope = 0;
  /// What the cubic of stationary curvature has become beside the line at infinity, x along the velocity: one asymptote
  /// is the inflection line. With the product 0 all points of that line have four-point contact with their tangents.
  /// Nothing where all paths are equally curved.
  std::optional<EquilateralHyperbola> circling_points{};

  /// Of the centres of curvature of those points; the same asymptotes.
  [[nodiscard]] std::optional<EquilateralHyperbola> centering_points() const {
    if (!circling_points) return std::nullopt;
    return EquilateralHyperbola{circling_points->center, circling_points->product + 1 / slope};
  }

  /// Where that vanishes; nothing where all paths are equally curved.
  [[nodiscard]] std::optional<StraightLine> inflection_line() const {
    if (!circling_points) return std::nullopt;
    return StraightLine{circling_points->center, velocity * Point{0, 1}};
  }
};

using Instant = std::variant<TurningInstant, PivotingInstant, TranslatingInstant>;

/// What a motion, known at least to the third order, tells at once; nothing of a body that rests (no turn, no
/// velocity).
[[nodiscard]] std::optional<Instant> instant_of(const MotionSeries& motion);

/// Nothing where the body translates: the pole is at infinity.
[[nodiscard]] std::optional<Point> pole_of(const Instant& instant);

/// Of the points whose paths have no curvature now; nothing where there are none.
[[nodiscard]] std::optional<CircleOrLine> inflection_circle(const Instant& instant);

/// Centre of curvature of the path of a point, from its first two derivatives; at infinity for a point that inflects,
/// nothing for one that rests (the pole).
[[nodiscard]] std::optional<Homogeneous> center_of_curvature(const MotionSeries& motion, Point point);

/// The point of the body without acceleration, where Bresse's circle meets the inflection circle once more; nothing
/// where the body neither turns nor begins to. `by_time`: the motion by time, on whose pace it depends.
[[nodiscard]] std::optional<Point> acceleration_pole(const MotionSeries& by_time);

/// Bresse's circle, of the points without tangential acceleration, (x² + y²) φ̈ + D φ̇² x = 0: the pole normal where the
/// body turns evenly, a line along the velocity where it translates. Nothing where every point is one, or the pole
/// only.
[[nodiscard]] std::optional<CircleOrLine> bresse_circle(const Instant& instant, const MotionSeries& by_time);

}  // namespace linkwright
