#include <algorithm>
#include <limits>
#include <numeric>

#include "linkwright/synthesis/tolerance_measures.hpp"

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

}  // namespace

void report_tolerances(Answer& answer, const Progress& progress) {
  Findings& found = findings(answer);
  if (!found.options.tolerances) return;
  const Tolerances& tolerances = *found.options.tolerances;
  for (const auto& output : listed_outputs(answer, tolerances.turning_length.value_or(0))) {
    const bool is_told = output && !progress.is_cancelled();
    found.tolerance.push_back(is_told ? tolerance_report(*output, tolerances, found.options.region.threads)
                                      : std::nullopt);
  }
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
