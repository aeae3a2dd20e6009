#include "linkwright/robust/tolerance_report.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "tolerance_error.hpp"

namespace linkwright {
namespace {

constexpr std::size_t least_realigned_positions = 3;

std::vector<ParameterShare> shares_of(const SensitivityMatrix& matrix, const std::vector<MadeDimension>& dimensions,
                                      const std::vector<double>& variances) {
  std::vector<ParameterShare> shares;
  for (VarianceShare& share : variance_shares(matrix, variances))
    if (variances[share.parameter] > 0)
      shares.push_back({dimensions[share.parameter].name, dimensions[share.parameter].tolerance,
                        dimensions[share.parameter].is_angle, share.share, std::move(share.per_position)});
  return shares;
}

std::vector<double> variances_of(const std::vector<MadeDimension>& dimensions, const Tolerances& tolerances) {
  std::vector<double> variances;
  for (const MadeDimension& made : dimensions) variances.push_back(made.variance(tolerances));
  return variances;
}

double error_of(const LinkageOutput& output, const SensitivityMatrix& matrix, const std::vector<double>& variances) {
  return is_line(output) ? line_tolerance_error(matrix, variances) : tolerance_error(matrix, variances);
}

// Of lines as they are: where they were drawn, or laid anew.
std::optional<ToleranceReport> report_of(const LinkageOutput& output, const Tolerances& tolerances, int threads) {
  const auto matrix = sensitivities(output);
  if (!matrix) return std::nullopt;
  const std::vector<MadeDimension> dimensions = made_dimensions(output, tolerances);
  const std::vector<double> variances = variances_of(dimensions, tolerances);
  std::vector<double> reaches;
  for (const MadeDimension& made : dimensions) reaches.push_back(made.reach(tolerances));
  ToleranceReport report;
  report.of_angle = is_angle(output);
  report.error = error_of(output, *matrix, variances);
  report.worst_case = worst_case(*matrix, reaches);
  report.shares = shares_of(*matrix, dimensions, variances);
  report.sampled = sample_errors(output, tolerances, threads);
  report.beyond_first_order = report.sampled.assembled() > 0 && report.sampled.is_beyond_first_order(report.error);
  if (report.error > 0 && !is_line(output))
    report.allocation = allocated_tolerances(*matrix, dimensions, tolerances, report.error);
  return report;
}

}  // namespace

double ToleranceReport::signal_to_noise() const {
  return sampled.signal_to_noise() - (of_angle ? 20 * std::log10(degrees(1)) : 0);
}

std::optional<double> first_order_error(const LinkageOutput& output, const Tolerances& tolerances) {
  const auto matrix = sensitivities(output);
  if (!matrix) return std::nullopt;
  return error_of(output, *matrix, variances_of(made_dimensions(output, tolerances), tolerances));
}

std::optional<ToleranceReport> tolerance_report(const LinkageOutput& output, const Tolerances& tolerances,
                                                int threads) {
  if (!is_line(output)) return report_of(output, tolerances, threads);
  auto line = std::get<PlanarOutput>(output);
  line.realigned = false;
  auto report = report_of(line, tolerances, threads);
  if (!report || line.positions.size() < least_realigned_positions) return report;
  line.realigned = true;
  if (const auto anew = report_of(line, tolerances, threads)) {
    report->error_realigned = anew->error;
    report->sampled_realigned = anew->sampled;
  }
  return report;
}

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
