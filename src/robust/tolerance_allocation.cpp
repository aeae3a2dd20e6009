#include "linkwright/robust/tolerance_allocation.hpp"

#include <cmath>
#include <limits>

#include "linkwright/core/precondition.hpp"
#include "tolerance_error.hpp"

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

std::optional<std::vector<ParameterTolerance>> allocated_tolerances(const SensitivityMatrix& matrix,
                                                                    std::span<const MadeDimension> dimensions,
                                                                    const Tolerances& tolerances, double error) {
  require(matrix.parameters() == dimensions.size(), "a dimension to each parameter");
  if (!tolerances.cost_exponent) return std::nullopt;
  const std::vector<double> all_weights = error_weights(matrix, standard_deviation(tolerances.distribution));
  std::vector<ParameterTolerance> allocated;
  std::vector<double> weights, staying;
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    MadeDimension rest = dimensions[i];
    if (!rest.is_driver) {
      if (rest.tolerance > 0 && all_weights[i] > 0) {
        allocated.push_back({rest.name, 0, rest.is_angle});
        weights.push_back(all_weights[i]);
      }
      rest.tolerance = 0;
    }
    staying.push_back(rest.variance(tolerances));
  }
  const double stays = tolerance_error(matrix, staying);
  if (!(error > stays) || weights.empty()) return std::nullopt;
  const double left = std::sqrt((error - stays) * (error + stays));
  const std::vector<double> cheapest = least_cost_tolerances(weights, left, *tolerances.cost_exponent);
  for (std::size_t k = 0; k < cheapest.size(); ++k) allocated[k].tolerance = cheapest[k];
  return allocated;
}

}  // namespace linkwright
