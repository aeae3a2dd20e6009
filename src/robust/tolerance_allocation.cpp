#include "linkwright/robust/tolerance_allocation.hpp"

#include <cmath>
#include <limits>

#include "linkwright/core/precondition.hpp"
#include "linkwright/robust/tolerance_error.hpp"

namespace linkwright {
std::vector<double> least_cost_tolerances(std::span<const double> weights, double error, double exponent) {
  require(error > 0 && exponent > 0, "an error and an exponent above zero");
  std::vector<double> tolerances;
  double square = 0;
  for (const double weight : weights) {
    tolerances.push_back(weight > 0 ? std::pow(weight, -2 / (exponent + 2)) : std::numeric_limits<double>::infinity());
    if (weight > 0) square += weight * tolerances.back() * weight * tolerances.back();
  }
  for (double& tolerance : tolerances) tolerance *= error / std::sqrt(square);
  return tolerances;
}

std::vector<double> error_weights(const SensitivityMatrix& matrix, double standard_deviation) {
  std::vector<double> weights(matrix.parameters());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    std::vector<double> alone(matrix.parameters());
    alone[i] = standard_deviation * standard_deviation;
    weights[i] = tolerance_error(matrix, alone);
  }
  return weights;
}

std::optional<std::vector<AllocatedTolerance>> allocated_tolerances(const SensitivityMatrix& matrix,
                                                                    const Tolerances& tolerances, double error) {
  require(matrix.parameters() == planar_parameters, "a planar four-bar");
  if (!tolerances.cost_exponent) return std::nullopt;
  Tolerances staying = tolerances;
  staying.length = {};
  const double stays = tolerance_error(matrix, planar_variances(staying));
  const PlanarValues half = planar_half_tolerances(tolerances);
  const std::vector<double> all_weights = error_weights(matrix, standard_deviation(tolerances.distribution));
  std::vector<AllocatedTolerance> allocated;
  std::vector<double> weights;
  for (std::size_t i = 0; i < static_cast<std::size_t>(PlanarParameter::driver); ++i) {
    if (!(half[i] > 0 && all_weights[i] > 0)) continue;
    allocated.push_back({static_cast<PlanarParameter>(i), 0});
    weights.push_back(all_weights[i]);
  }
  if (!(error > stays) || weights.empty()) return std::nullopt;
  const double left = std::sqrt((error - stays) * (error + stays));
  const std::vector<double> cheapest = least_cost_tolerances(weights, left, *tolerances.cost_exponent);
  for (std::size_t k = 0; k < cheapest.size(); ++k) allocated[k].tolerance = cheapest[k];
  return allocated;
}

}  // namespace linkwright
