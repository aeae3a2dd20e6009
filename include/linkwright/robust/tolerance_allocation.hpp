#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/robust/made_dimension.hpp"
#include "linkwright/robust/sensitivity.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

/// The half tolerances T_i of least total cost Σ T_i^−k that keep √Σ (w_i T_i)² = error, in closed form by Lagrange:
/// T_i ∝ w_i^(−2/(k + 2)). Infinite where w_i = 0: that one does not matter. error > 0, k > 0, w_i ≥ 0.
[[nodiscard]] std::vector<double> least_cost_tolerances(std::span<const double> weights, double error, double exponent);

/// The weights of tolerance_error(): √(mean over the positions of a parameter's squared sensitivity), times σ / T of
/// its distribution.
[[nodiscard]] std::vector<double> error_weights(const SensitivityMatrix& matrix, double standard_deviation);

struct ParameterTolerance {
  std::string parameter;
  double tolerance = 0;  ///< half, user's unit; of arcs radians
  bool is_angle = false;
};
/// Those of the dimensions that have a tolerance and whose tolerance matters, such that tolerance_error() is `error`;
/// clearance and driver stay as they are. Nothing without a cost exponent, and where what stays leaves no room.
[[nodiscard]] std::optional<std::vector<ParameterTolerance>> allocated_tolerances(
    const SensitivityMatrix& matrix, std::span<const MadeDimension> dimensions, const Tolerances& tolerances,
    double error);

}  // namespace linkwright
