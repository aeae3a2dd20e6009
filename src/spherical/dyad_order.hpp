#pragma once

#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// The same dyad with the sense of its fixed axis chosen so that the link is at most 90°.
[[nodiscard]] inline SphericalDyad with_acute_link(SphericalDyad dyad) {
  if (dot(dyad.fixed_axis, dyad.moving_axis) < 0) dyad.fixed_axis = -dyad.fixed_axis;
  return dyad;
}

/// The order of the dyads of five orientations: by the acute angle of the link, or its tangent.
[[nodiscard]] inline bool has_shorter_link(const SphericalDyad& a, const SphericalDyad& b) {
  const Vector3 sine_a = cross(a.fixed_axis, a.moving_axis), sine_b = cross(b.fixed_axis, b.moving_axis);
  const double cosine_a = dot(a.fixed_axis, a.moving_axis), cosine_b = dot(b.fixed_axis, b.moving_axis);
  return dot(sine_a, sine_a) * (cosine_b * cosine_b) < dot(sine_b, sine_b) * (cosine_a * cosine_a);
}

}  // namespace linkwright
