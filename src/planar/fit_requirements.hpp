#pragma once

#include <algorithm>
#include <cmath>

#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// Share of a limit by which fits are held inside it, twice their slack: what keeps a limit by it keeps it by the
/// figures told.
inline constexpr double fit_inside = 2e-6;

/// Least transmission angle to which fits are held, radians. Where none is asked for they yet keep off dead points, at
/// which they would end with round-off deciding what they do.
[[nodiscard]] inline double fitted_transmission_angle(const Requirements& requirements) {
  constexpr double off_dead_points = 1e-3;
  const double least_sine = std::max(std::sin(requirements.min_transmission_angle) + fit_inside, off_dead_points);
  return std::asin(std::min(least_sine, 1.0));
}

}  // namespace linkwright
