#include <fmt/format.h>
#include <limits>

#include "analyses/listed_again.hpp"
#include "linkwright/core/angle.hpp"
#include "synthesis/listed_linkages.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

// Larger is better. A map ranks by few samples or to first order; what is listed is known better.
double score_of(const std::optional<ToleranceReport>& report, Objective objective) {
  if (!report || report->sampled.assembled() == 0) return -std::numeric_limits<double>::infinity();
  if (objective == Objective::yield && report->sampled.yield) return report->sampled.yield->share;
  return -report->listed_error();
}

bool is_ours(const Measure& measure) { return measure == measures::tolerance_error || measure == measures::yield; }

/// What is listed of it by a measure: the map knows few samples, and of straight lines few places.
std::optional<double> listed(const ToleranceReport& report, const Measure& measure) {
  if (measure == measures::tolerance_error)
    return report.of_angle ? degrees(report.listed_error()) : report.listed_error();
  return report.sampled.yield ? std::optional(report.sampled.yield->share) : std::nullopt;
}

ListedMeasures listed_measures(const Findings& found) {
  return {is_ours, [&found](std::size_t linkage, const Measure& measure) {
            const auto& report = found.tolerance[linkage];
            return report ? listed(*report, measure) : std::nullopt;
          }};
}

void leave_out_what_fails(Answer& answer) {
  Findings& found = findings(answer);
  const std::size_t count = leave_out_what_fails(answer, listed_measures(found)).count;
  if (count == 0) return;
  found.warnings.push_back(
      {"left_out_by_tolerances",
       fmt::format("{} of the best {} discarded: by the solution region, which knows few samples, {} what is required "
                   "under tolerances, but not by the figures that would be listed.",
                   count, count == 1 ? "was" : "were", count == 1 ? "it meets" : "they meet"),
       {{"count", static_cast<double>(count)}}});
}

}  // namespace

void report_tolerances(Answer& answer, const Progress& progress) {
  Findings& found = findings(answer);
  const Tolerances& tolerances = *found.options.tolerances;
  for (const auto& output : listed_outputs(answer, tolerances.turning_length.value_or(0))) {
    const bool is_told = output && !progress.is_cancelled();
    found.tolerance.push_back(is_told ? tolerance_report(*output, tolerances, found.options.region.threads)
                                      : std::nullopt);
  }
  if (!found.options.at && !progress.is_cancelled()) leave_out_what_fails(answer);
  rank_again(answer, listed_measures(found),
             [&](std::size_t i) { return score_of(found.tolerance[i], found.options.objective); });
}

}  // namespace linkwright
