#include "linkwright/robust/tolerance_report.hpp"

#include <utility>

#include "linkwright/robust/tolerance_error.hpp"

namespace linkwright {
namespace {

constexpr std::size_t least_realigned_positions = 3;

std::vector<ParameterShare> shares_of(const SensitivityMatrix& matrix, const std::vector<MadeDimension>& dimensions,
                                      const std::vector<double>& variances) {
  std::vector<ParameterShare> shares;
  for (VarianceShare& share : variance_shares(matrix, variances))
    if (variances[share.parameter] > 0)
      shares.push_back({dimensions[share.parameter].name, dimensions[share.parameter].tolerance, share.share,
                        std::move(share.per_position)});
  return shares;
}

// Of lines as they are: where they were drawn, or laid anew.
std::optional<ToleranceReport> report_of(const LinkageOutput& output, const Tolerances& tolerances, int threads) {
  const auto matrix = sensitivities(output);
  if (!matrix) return std::nullopt;
  const std::vector<MadeDimension> dimensions = made_dimensions(output, tolerances);
  std::vector<double> variances, reaches;
  for (const MadeDimension& made : dimensions) {
    variances.push_back(made.variance(tolerances));
    reaches.push_back(made.reach(tolerances));
  }
  ToleranceReport report;
  report.error = is_line(output) ? line_tolerance_error(*matrix, variances) : tolerance_error(*matrix, variances);
  report.worst_case = worst_case(*matrix, reaches);
  report.shares = shares_of(*matrix, dimensions, variances);
  report.sampled = sample_errors(output, tolerances, threads);
  report.beyond_first_order = report.sampled.assembled() > 0 && report.sampled.is_beyond_first_order(report.error);
  if (report.error > 0 && !is_line(output))
    report.allocation = allocated_tolerances(*matrix, dimensions, tolerances, report.error);
  return report;
}

}  // namespace

std::optional<ToleranceReport> tolerance_report(const LinkageOutput& output, const Tolerances& tolerances,
                                                int threads) {
  if (!is_line(output)) return report_of(output, tolerances, threads);
  auto line = std::get<PlanarOutput>(output);
  line.realigned = false;
  auto report = report_of(line, tolerances, threads);
  if (!report || line.positions.size() < least_realigned_positions) return report;
  line.realigned = true;
  const auto anew = report_of(line, tolerances, threads).value();
  report->error_realigned = anew.error;
  report->sampled_realigned = anew.sampled;
  return report;
}

}  // namespace linkwright
