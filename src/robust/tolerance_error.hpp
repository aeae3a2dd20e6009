#pragma once

#include <span>
#include <vector>

#include "linkwright/robust/sensitivity.hpp"

namespace linkwright {

// To first order, parameters being independent. `variances` and `half_tolerances`: a number to each parameter of the
// matrix.

/// √(mean over the positions of the error's variance), its components together: for poses √(mean of σx² + σy² + (Lθ
/// σθ)²), for functions √(mean of σψ²).
[[nodiscard]] double tolerance_error(const SensitivityMatrix& matrix, std::span<const double> variances);
/// Three times the largest standard deviation over the positions: the error of a straight line.
[[nodiscard]] double line_tolerance_error(const SensitivityMatrix& matrix, std::span<const double> variances);
/// Of the error in each position, its components together.
[[nodiscard]] std::vector<double> standard_deviations(const SensitivityMatrix& matrix,
                                                      std::span<const double> variances);

/// Largest error over the positions when no parameter is off by more than its half tolerance: exact for an error of one
/// component; otherwise each component's largest together, which they need not take at once.
[[nodiscard]] double worst_case(const SensitivityMatrix& matrix, std::span<const double> half_tolerances);

/// What one parameter contributes to the variance of the error.
struct VarianceShare {
  std::size_t parameter = 0;
  double share = 0;                  ///< of all positions together; sums to one over the parameters
  std::vector<double> per_position;  ///< of the variance in each; sums to one over the parameters
};
/// Of all parameters, largest first; all zero where nothing varies.
[[nodiscard]] std::vector<VarianceShare> variance_shares(const SensitivityMatrix& matrix,
                                                         std::span<const double> variances);

}  // namespace linkwright
