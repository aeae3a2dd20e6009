#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/robust/made_dimension.hpp"
#include "linkwright/robust/sensitivity.hpp"
#include "linkwright/robust/tolerance_sampling.hpp"
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

/// What one parameter contributes to the variance of the error, to first order.
struct ParameterShare {
  std::string parameter;
  double tolerance = 0;              ///< half; clearance left out
  bool is_angle = false;             ///< of the parameter: radians
  double share = 0;                  ///< of all positions together
  std::vector<double> per_position;  ///< of the variance in each
};

/// What tolerances do to one linkage. Errors: user's unit, those of functions and spheres radians.
struct ToleranceReport {
  bool of_angle = false;                  ///< errors are angles
  double error = 0;                       ///< to first order; of a straight line where it was drawn
  std::optional<double> error_realigned;  ///< of straight lines: the line laid anew in each linkage made
  double worst_case = 0;                  ///< to first order
  SampledErrors sampled;
  std::optional<SampledErrors> sampled_realigned;  ///< of straight lines
  bool beyond_first_order = false;                 ///< the sampled error is the one to be listed
  /// Largest share first; those that cannot be off left out, and clearance counted with its link's length.
  std::vector<ParameterShare> shares;
  /// The tolerances of least cost that keep `error`, with Tolerances::cost_exponent; never of straight lines.
  std::optional<std::vector<ParameterTolerance>> allocation;

  /// SampledErrors::signal_to_noise() of errors as people read them: of angles in degrees.
  [[nodiscard]] double signal_to_noise() const;
  [[nodiscard]] double listed_error() const { return beyond_first_order ? sampled.error : error; }
};

/// tolerance_error(), or of a straight line line_tolerance_error(). Nothing at a dead point.
[[nodiscard]] std::optional<double> first_order_error(const LinkageOutput& output, const Tolerances& tolerances);

/// Nothing at a dead point. At most most_sampled_positions; PlanarOutput::realigned is of no account, and a stroke of
/// less than three positions is not realigned.
[[nodiscard]] std::optional<ToleranceReport> tolerance_report(const LinkageOutput& output, const Tolerances& tolerances,
                                                              int threads = 0);

}  // namespace linkwright
