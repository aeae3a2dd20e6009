#pragma once

#include <optional>

#include "linkwright/analysis/position.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// First and second derivatives of the coupler and output angles by the input angle
/// (times the input's angular velocity, and its square, they are velocities and accelerations at constant drive).
struct AngleRates {
  double coupler = 0, output = 0;                            ///< dθ/dφ
  double coupler_acceleration = 0, output_acceleration = 0;  ///< d²θ/dφ²
};

/// Rates at a configuration in which the loop closes; nothing at a dead point (tolerance::dead_point_sine), where they
/// are unbounded.
[[nodiscard]] std::optional<AngleRates> angle_rates(const LinkLengths& lengths, const Configuration& configuration);

}  // namespace linkwright
