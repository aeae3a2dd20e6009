#include "approximate/curve_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "approximate/fit_parts.hpp"
#include "approximate/limit_refit.hpp"
#include "approximate/start_list.hpp"

namespace linkwright {
namespace {

class Search {
 public:
  Search(const ScaledTarget& target, const FitLimits& limits, const CurveFitOptions& options, const Progress& progress)
      : target_(target),
        options_(options),
        progress_(progress),
        effort_(search_effort(options.effort)),
        chosen_(target.chosen_points()),
        chosen_weights_(target.chosen_weights()),
        limits_(limits),
        coarse_{chosen_, chosen_weights_, limits},
        fine_{target.points, target.weights, limits} {}

  CurveSearch run() {
    CurveSearch found;
    std::vector<CurveStart> starts = starts_of(scanned_pairs(), chosen_);
    found.places = effort_.places;
    found.starts = starts.size();
    improve_all(starts, coarse_, 4, 0.4, 0.5);
    keep_best(starts, 2 * starts.size() / 5, 2 * starts.size() / 5);
    improve_all(starts, coarse_, 12, 0.5, 0.65);
    keep_best(starts, effort_.clean, effort_.any);
    improve_all(starts, coarse_, 150, 0.65, 0.85);
    keep_distinct(starts);
    spread(starts);
    improve_all(starts, fine_, 60, 0.85, 0.95);
    creep(starts);
    keep_to_limits(starts);
    keep_distinct(starts);
    found.minima = std::move(starts);
    found.cancelled = progress_.is_cancelled();
    return found;
  }

 private:
  void for_all(std::size_t count, double from, double to, const std::function<void(std::size_t)>& body) {
    for_all_in_parts(count, options_.threads, progress_, from, to, body);
  }

  std::vector<ScannedPair> scanned_pairs() {
    const std::vector<Point> places = pivot_places(effort_.places, target_.points, limits_.ground);
    std::vector<std::vector<ScannedPair>> at(places.size());
    for_all(places.size(), 0, 0.4, [&](std::size_t k) {
      at[k] = scan_pivot(target_, chosen_, chosen_weights_, places[k], limits_.max_length, options_.simd);
    });
    std::vector<ScannedPair> pairs;
    for (const auto& here : at) pairs.insert(pairs.end(), here.begin(), here.end());
    return distinct_pairs(std::move(pairs), effort_.starts);
  }

  // A linkage with defects is held to lengths and windows alone.
  FitTask task_of(const FitTask& task, const CurveStart& start) const {
    FitTask own = task;
    if (start.branch != 0) return own;
    own.limits.grashof_margin = -FitLimits::unlimited;
    own.limits.min_turn_sine = 0;
    return own;
  }

  void improve_all(std::vector<CurveStart>& starts, const FitTask& task, int iterations, double from, double to) {
    for_all(starts.size(), from, to, [&](std::size_t k) {
      const FitTask own = task_of(task, starts[k]);
      turn_within_limits(own.limits, starts[k]);
      evaluate(own, starts[k]);
      improve(own, starts[k], iterations);
    });
    sort_by_cost(starts);
  }

  // States at the other points begin between those at the chosen ones.
  void spread(std::vector<CurveStart>& starts) {
    if (target_.chosen.size() == target_.points.size()) return;
    std::vector<CurveStart> kept;
    for (CurveStart& start : starts) {
      start.converged = false;
      if (spread_to_all_points(target_, start)) kept.push_back(std::move(start));
    }
    starts = std::move(kept);
  }

  // Near circles and straight lines least squares creep along flat valleys: the best get longer.
  void creep(std::vector<CurveStart>& starts) {
    std::size_t far = effort_.creeping, compact = effort_.creeping;
    std::vector<CurveStart> creeping, others;
    for (CurveStart& start : starts) {
      std::size_t& left = is_compact(start.linkage) ? compact : far;
      const bool goes_on = start.branch != 0 && left > 0;
      if (goes_on) --left;
      start.converged = false;
      (goes_on ? creeping : others).push_back(std::move(start));
    }
    improve_all(creeping, fine_, effort_.creeping_iterations, 0.95, 0.98);
    for (CurveStart& start : others) creeping.push_back(std::move(start));
    starts = std::move(creeping);
  }

  // Those without defects; where the largest distance counts, the best of them are fitted to it.
  void keep_to_limits(std::vector<CurveStart>& starts) {
    constexpr std::size_t best = 12;
    for_all(starts.size(), 0.98, 1, [&](std::size_t k) {
      CurveStart& start = starts[k];
      const FitTask own = task_of(fine_, start);
      if (options_.measure == FitMeasure::least_largest && k < best) fit_least_largest(own, start);
      refit_within_limits(own, start);
      slide_to_nearest(own, start);
    });
    sort_by_cost(starts);
  }

  const ScaledTarget& target_;
  const CurveFitOptions& options_;
  const Progress& progress_;
  SearchEffort effort_;
  std::vector<Point> chosen_;
  std::vector<double> chosen_weights_;
  FitLimits limits_;
  FitTask coarse_, fine_;
};

}  // namespace

SearchEffort search_effort(FitEffort effort) {
  switch (effort) {
    case FitEffort::quick:
      return {350, 160, 20, 6, 5, 1500};
    case FitEffort::deep:
      return {22400, 12800, 480, 160, 24, 10000};
    default:
      return {1400, 800, 60, 20, 7, 4000};
  }
}

CurveSearch search_curves(const ScaledTarget& target, const FitLimits& limits, const CurveFitOptions& options,
                          const Progress& progress) {
  return Search(target, limits, options, progress).run();
}

}  // namespace linkwright
