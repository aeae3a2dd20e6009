#pragma once

#include <array>
#include <optional>

#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// Angles (φ, θ, ψ) of input, coupler and output link from the four-bar's own axis: a point of the torus, or a
/// difference of two, radians.
struct TorusVector {
  double input = 0, coupler = 0, output = 0;
};

[[nodiscard]] inline TorusVector operator+(TorusVector a, TorusVector b) {
  return {a.input + b.input, a.coupler + b.coupler, a.output + b.output};
}
[[nodiscard]] inline TorusVector operator*(double s, TorusVector a) {
  return {s * a.input, s * a.coupler, s * a.output};
}
[[nodiscard]] inline double dot(TorusVector a, TorusVector b) {
  return a.input * b.input + a.coupler * b.coupler + a.output * b.output;
}
[[nodiscard]] inline TorusVector cross(TorusVector a, TorusVector b) {
  return {a.coupler * b.output - a.output * b.coupler, a.output * b.input - a.input * b.output,
          a.input * b.coupler - a.coupler * b.input};
}
[[nodiscard]] double norm(TorusVector a);

/// The shortest way from one point of the torus to another, each angle of both in [−π, π].
[[nodiscard]] TorusVector shortest_way(TorusVector from, TorusVector to);

/// The same point with each angle in [−π, π]; angles at most a turn outside.
[[nodiscard]] TorusVector wrapped(TorusVector point);

/// The configurations of a four-bar as the curve on the torus where the loop closes:
/// F(φ, θ, ψ) = (a e^{iφ} + h e^{iθ} − g − b e^{iψ}) / perimeter = 0.
/// Nothing here knows of linkage types, assemblies or dead points.
class ConfigurationCurve {
 public:
  /// Finite positive lengths.
  explicit ConfigurationCurve(const LinkLengths& lengths);

  /// The curve near one of its points: a ball in which it is one strand that crosses each plane normal to `tangent` at
  /// most once, and turns by less than 20°.
  struct Strand {
    TorusVector point;
    TorusVector tangent;        ///< unit vector whose φ-component has the sign of the Jacobian by (θ, ψ); continuous
    double reach = 0;           ///< radius of the ball, radians
    double singular_value = 0;  ///< of the Jacobian, the smaller one
    double closure_error = 0;   ///< |F|
  };
  [[nodiscard]] Strand strand_at(TorusVector point) const;

  /// The point of the strand in the plane normal to its tangent, `along` from its point (at most the reach), by
  /// Newton's method until |F| ≤ accuracy, and less where the strand's reach asks for it; nothing where that fails.
  [[nodiscard]] std::optional<TorusVector> advanced(const Strand& strand, double along, double accuracy) const;

  /// The input's and the output's moving pivot, own frame, user's unit.
  [[nodiscard]] std::array<Point, 2> moving_pivots(TorusVector point) const;

 private:
  struct Loop {
    Point closure;                          ///< F
    Point by_input, by_coupler, by_output;  ///< columns of its Jacobian
  };
  [[nodiscard]] Loop loop_at(TorusVector point) const;

  LinkLengths lengths_, shape_;  ///< shape_: over the perimeter
};

}  // namespace linkwright
