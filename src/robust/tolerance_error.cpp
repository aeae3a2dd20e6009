#include "tolerance_error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

double squared_sensitivity(const SensitivityMatrix& matrix, std::size_t position, std::size_t parameter) {
  double sum = 0;
  for (std::size_t c = 0; c < matrix.components(); ++c)
    sum += matrix.row(position, c)[parameter] * matrix.row(position, c)[parameter];
  return sum;
}

double variance_at(const SensitivityMatrix& matrix, std::size_t position, std::span<const double> variances) {
  double sum = 0;
  for (std::size_t i = 0; i < matrix.parameters(); ++i) sum += squared_sensitivity(matrix, position, i) * variances[i];
  return sum;
}

void require_a_number_each(const SensitivityMatrix& matrix, std::span<const double> values) {
  require(values.size() == matrix.parameters(), "a number to each parameter");
}

double share_of(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

std::vector<double> standard_deviations(const SensitivityMatrix& matrix, std::span<const double> variances) {
  require_a_number_each(matrix, variances);
  std::vector<double> deviations(matrix.positions());
  for (std::size_t j = 0; j < deviations.size(); ++j) deviations[j] = std::sqrt(variance_at(matrix, j, variances));
  return deviations;
}

double tolerance_error(const SensitivityMatrix& matrix, std::span<const double> variances) {
  require_a_number_each(matrix, variances);
  double sum = 0;
  for (std::size_t j = 0; j < matrix.positions(); ++j) sum += variance_at(matrix, j, variances);
  return std::sqrt(sum / static_cast<double>(matrix.positions()));
}

double line_tolerance_error(const SensitivityMatrix& matrix, std::span<const double> variances) {
  const std::vector<double> deviations = standard_deviations(matrix, variances);
  return 3 * *std::max_element(deviations.begin(), deviations.end());
}

double worst_case(const SensitivityMatrix& matrix, std::span<const double> half_tolerances) {
  require_a_number_each(matrix, half_tolerances);
  double worst = 0;
  for (std::size_t j = 0; j < matrix.positions(); ++j) {
    double square = 0;
    for (std::size_t c = 0; c < matrix.components(); ++c) {
      double most = 0;
      for (std::size_t i = 0; i < matrix.parameters(); ++i) most += std::abs(matrix.row(j, c)[i]) * half_tolerances[i];
      square += most * most;
    }
    worst = std::max(worst, std::sqrt(square));
  }
  return worst;
}

std::vector<VarianceShare> variance_shares(const SensitivityMatrix& matrix, std::span<const double> variances) {
  require_a_number_each(matrix, variances);
  std::vector<double> whole(matrix.positions());
  for (std::size_t j = 0; j < whole.size(); ++j) whole[j] = variance_at(matrix, j, variances);
  const double all = std::accumulate(whole.begin(), whole.end(), 0.0);
  std::vector<VarianceShare> shares;
  for (std::size_t i = 0; i < matrix.parameters(); ++i) {
    VarianceShare share{i, 0, {}};
    for (std::size_t j = 0; j < whole.size(); ++j) {
      const double part = squared_sensitivity(matrix, j, i) * variances[i];
      share.share += share_of(part, all);
      share.per_position.push_back(share_of(part, whole[j]));
    }
    shares.push_back(std::move(share));
  }
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  return shares;
}

}  // namespace linkwright
