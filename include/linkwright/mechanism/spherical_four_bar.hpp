#pragma once

#include <algorithm>
#include <array>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {

/// A grounded link of a spherical linkage: an axis of the frame and an axis of the body, as it lies in position 1; unit
/// vectors of the fixed frame. A line through the centre has two senses, so (G, W), (−G, W), (G, −W) and (−G, −W) are
/// one link.
struct SphericalDyad {
  Vector3 fixed_axis, moving_axis;
  double coordinate = 0;  ///< the place on the curve of dyads (identity of the dyad)

  /// ∠(G, W) in [0, π].
  [[nodiscard]] double angle() const { return angle_between(fixed_axis, moving_axis); }

  friend bool operator==(const SphericalDyad&, const SphericalDyad&) = default;
};

/// What stands at a coordinate that has no dyad: no axes, so that every pair with it is degenerate.
[[nodiscard]] inline SphericalDyad no_spherical_dyad(double coordinate) { return {{}, {}, coordinate}; }

/// The link angles of a spherical four-bar, radians in [0, π].
struct LinkAngles {
  double ground = 0, input = 0, coupler = 0, output = 0;

  [[nodiscard]] std::array<double, 4> all() const { return {ground, input, coupler, output}; }
  [[nodiscard]] double sum() const { return ground + input + coupler + output; }
  /// The least and the largest of the links, in [0, π/2]: an angle and its supplement are the same link.
  [[nodiscard]] double shortest() const {
    return std::min({acute(ground), acute(input), acute(coupler), acute(output)});
  }
  [[nodiscard]] double longest() const {
    return std::max({acute(ground), acute(input), acute(coupler), acute(output)});
  }

 private:
  [[nodiscard]] static double acute(double angle) { return std::min(angle, pi - angle); }
};

/// A spherical four-bar: four axes through one centre, in some position, unit vectors of the fixed frame.
struct SphericalFourBar {
  Vector3 input_fixed, input_moving, output_moving, output_fixed;

  [[nodiscard]] LinkAngles angles() const {
    return {angle_between(input_fixed, output_fixed), angle_between(input_fixed, input_moving),
            angle_between(input_moving, output_moving), angle_between(output_fixed, output_moving)};
  }
  /// The same bars driven from the other grounded link.
  [[nodiscard]] SphericalFourBar swapped() const { return {output_fixed, output_moving, input_moving, input_fixed}; }

  friend bool operator==(const SphericalFourBar&, const SphericalFourBar&) = default;
};

/// The same bars with the senses of their axes chosen so that input and output link are at most 90° and, where that
/// leaves a choice, the coupler too: of the two ways to turn both axes of the grounded links around, the one with the
/// shorter coupler.
[[nodiscard]] inline SphericalFourBar with_short_links(SphericalFourBar bars) {
  if (dot(bars.input_moving, bars.output_moving) < 0) {
    bars.output_moving = -bars.output_moving;
    bars.output_fixed = -bars.output_fixed;
  }
  if (dot(bars.input_fixed, bars.input_moving) < 0) bars.input_fixed = -bars.input_fixed;
  if (dot(bars.output_fixed, bars.output_moving) < 0) bars.output_fixed = -bars.output_fixed;
  return bars;
}

}  // namespace linkwright
