#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <numeric>

#include "linkwright/core/angle.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

// Larger is better. A map ranks by few samples or to first order; what is listed is known better.
double score_of(const std::optional<ToleranceReport>& report, Objective objective) {
  if (!report || report->sampled.assembled() == 0) return -std::numeric_limits<double>::infinity();
  if (objective == Objective::yield && report->sampled.yield) return report->sampled.yield->share;
  return -report->listed_error();
}

template <class Item>
void reorder(std::vector<Item>& items, const std::vector<std::size_t>& order) {
  std::vector<Item> sorted;
  sorted.reserve(items.size());
  for (const std::size_t place : order) sorted.push_back(std::move(items[place]));
  items = std::move(sorted);
}

// By what is listed of it: the map knows few samples, and of straight lines few places.
bool meets(const std::optional<ToleranceReport>& report, const Requirements& wanted) {
  if (wanted.max_tolerance_error < Requirements::unlimited) {
    if (!report) return false;
    const double error = report->listed_error();
    if (!((report->of_angle ? degrees(error) : error) <= wanted.max_tolerance_error)) return false;
  }
  if (!(wanted.min_yield > 0)) return true;
  return report && report->sampled.yield && report->sampled.yield->share >= wanted.min_yield;
}

void leave_out_what_fails(Answer& answer) {
  Findings& found = findings(answer);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < found.tolerance.size(); ++i)
    if (meets(found.tolerance[i], found.requirements)) kept.push_back(i);
  const std::size_t count = found.tolerance.size() - kept.size();
  if (count == 0) return;
  reorder(found.tolerance, kept);
  std::visit([&](auto& of_kind) { reorder(of_kind.linkages, kept); }, answer);
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
  if (!is_of_tolerances(found.options.objective) || found.options.at || found.options.pareto) return;
  std::vector<std::size_t> order(found.tolerance.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return score_of(found.tolerance[a], found.options.objective) >
           score_of(found.tolerance[b], found.options.objective);
  });
  reorder(found.tolerance, order);
  std::visit([&](auto& of_kind) { reorder(of_kind.linkages, order); }, answer);
}

}  // namespace linkwright
