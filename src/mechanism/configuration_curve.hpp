#pragma once

#include <array>
#include <optional>

#include "linkwright/algebra/point.hpp"
#include "linkwright/algebra/vector3.hpp"
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

/// Two points, or their velocities.
using HingePlaces = std::array<Vector3, 2>;

/// The configurations of a linkage of one degree of freedom as the curve on the torus where its loop closes. Nothing
/// here knows of linkage types, assemblies or dead points.
class ConfigurationCurve {
 public:
  ConfigurationCurve() = default;
  ConfigurationCurve(const ConfigurationCurve&) = delete;
  ConfigurationCurve& operator=(const ConfigurationCurve&) = delete;
  virtual ~ConfigurationCurve() = default;

  /// The curve near one of its points: a ball in which it is one strand that crosses each plane normal to `tangent` at
  /// most once, and turns by less than 20°.
  struct Strand {
    TorusVector point;
    TorusVector tangent;  ///< unit vector whose φ-component has the sign of the Jacobian by the others; continuous
    double reach = 0;     ///< radius of the ball, radians
    double singular_value = 0;  ///< of the Jacobian, the smaller one
    double closure_error = 0;   ///< |F|
  };
  [[nodiscard]] virtual Strand strand_at(TorusVector point) const = 0;

  /// The point of the strand in the plane normal to its tangent, `along` from its point (at most the reach), by
  /// Newton's method until |F| ≤ accuracy, and less where the strand's reach asks for it; nothing where that fails.
  [[nodiscard]] virtual std::optional<TorusVector> advanced(const Strand& strand, double along,
                                                            double accuracy) const = 0;

  /// Coordinates of the input's and the output's moving hinge, own frame; in the plane, z = 0.
  [[nodiscard]] virtual HingePlaces moving_hinges(TorusVector point) const = 0;
};

/// The curve of a planar four-bar, F(φ, θ, ψ) = (a e^{iφ} + h e^{iθ} − g − b e^{iψ}) / perimeter = 0.
class PlanarConfigurationCurve : public ConfigurationCurve {
 public:
  /// Finite positive lengths.
  explicit PlanarConfigurationCurve(const LinkLengths& lengths);

  [[nodiscard]] Strand strand_at(TorusVector point) const override;
  [[nodiscard]] std::optional<TorusVector> advanced(const Strand& strand, double along, double accuracy) const override;
  [[nodiscard]] HingePlaces moving_hinges(TorusVector point) const override;

 private:
  struct Loop {
    Point closure;                          ///< F
    Point by_input, by_coupler, by_output;  ///< columns of its Jacobian
  };
  [[nodiscard]] Loop loop_at(TorusVector point) const;

  LinkLengths lengths_, shape_;  ///< shape_: over the perimeter
};

}  // namespace linkwright
