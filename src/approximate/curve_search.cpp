#include "approximate/curve_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "approximate/fit_parts.hpp"
#include "approximate/given_start.hpp"
#include "approximate/limit_refit.hpp"
#include "approximate/start_list.hpp"

namespace linkwright {
namespace {

// Fixed pivots that stand somewhere, in the frame of the target.
class GivenPivots {
 public:
  GivenPivots(const CurveFitOptions& options, const ScaledTarget& target) {
    if (options.input_pivot) input_ = target.scaled(*options.input_pivot);
    if (options.output_pivot) output_ = target.scaled(*options.output_pivot);
  }

  [[nodiscard]] bool any() const { return input_ || output_; }
  /// At which pairs are scanned, and the other one.
  [[nodiscard]] Point first() const { return input_ ? *input_ : *output_; }
  [[nodiscard]] std::optional<Point> second() const { return input_ ? output_ : std::nullopt; }
  /// Of the pairs scanned: on an output's pivot stands what is driven from elsewhere, and both pivots are of one
  /// four-bar.
  [[nodiscard]] std::string_view drivers() const { return !input_ ? "g" : output_ ? "e" : "eu"; }

  /// Its fixed pivots are brought there; false where its loops do not close then.
  [[nodiscard]] bool take(CurveStart& start) const {
    if (input_) start.linkage.a0 = *input_;
    if (output_) start.linkage.b0 = *output_;
    return !any() || std::all_of(start.states.begin(), start.states.end(),
                                 [&](LoopState& state) { return close_loop(start.linkage, state); });
  }

  /// Those without a driver are also led away from their dead points: there are few starts at one place.
  void hold(std::vector<CurveStart>& starts) const {
    constexpr unsigned first_pivot = 0b0011, second_pivot = 0b1100;
    if (!any()) return;
    std::vector<CurveStart> led;
    for (CurveStart& start : starts) {
      if (!input_ && start.branch == 0) start = driven_by_output(std::move(start));
      start.held = (input_ ? first_pivot : 0) | (output_ ? second_pivot : 0);
      if (start.branch == 0) led.push_back(kept_to_branch(start));
    }
    std::move(led.begin(), led.end(), std::back_inserter(starts));
  }

 private:
  std::optional<Point> input_, output_;
};

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
        given_(options, target),
        coarse_{chosen_, chosen_weights_, limits},
        fine_{target.points, target.weights, limits} {}

  CurveSearch run() {
    CurveSearch found;
    std::vector<CurveStart> starts = starts_of(scanned_pairs(), chosen_);
    given_.hold(starts);
    found.places = given_.any() ? 1 : effort_.places;
    found.starts = starts.size();
    improve_all(starts, coarse_, 4, 0.4, 0.5);
    keep_best(starts, 2 * starts.size() / 5, 2 * starts.size() / 5);
    improve_all(starts, coarse_, 12, 0.5, 0.65);
    keep_best(starts, effort_.clean, effort_.any);
    improve_all(starts, coarse_, 150, 0.65, 0.85);
    keep_distinct(starts);
    spread(starts);
    add_given(starts, found);
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

  // At the places of a spiral, or again and again where a pivot is given: each time by other lengths.
  std::vector<ScannedPair> scanned_pairs() {
    std::vector<std::vector<ScannedPair>> at(given_.any() ? effort_.rounds : effort_.places);
    const std::vector<Point> places = given_.any() ? std::vector<Point>(at.size(), given_.first())
                                                   : pivot_places(at.size(), target_.points, limits_.ground);
    for_all(at.size(), 0, 0.4, [&](std::size_t k) {
      PairWishes wishes{dyad_grid(k)};
      if (given_.any()) wishes = {dyad_grid(k), given_.drivers(), given_.second()};
      at[k] = scan_pivot(target_, chosen_, chosen_weights_, places[k], limits_.max_length, options_.simd, wishes);
    });
    std::vector<ScannedPair> pairs;
    for (const auto& here : at) pairs.insert(pairs.end(), here.begin(), here.end());
    return distinct_pairs(std::move(pairs), effort_.starts);
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

  // Linkages that are given to begin with, on all points: held to the branch on which they lie, and not.
  void add_given(std::vector<CurveStart>& starts, CurveSearch& found) {
    std::vector<CurveStart> given;
    for (const TracingFourBar& linkage : options_.starts) {
      const TracingFourBar scaled = target_.scaled_linkage(linkage);
      if (!is_usable_start(scaled.bars) || !is_finite(scaled.point)) continue;
      auto start = start_in_turn(coupler_linkage(scaled), loop_state(scaled), target_.points);
      if (!start || !given_.take(*start)) continue;
      given.push_back(kept_to_branch(*start));
      given.push_back(*std::move(start));
    }
    given_.hold(given);
    found.given = within_limits(fine_, given);
    found.starts += given.size();
    improve_all(given, fine_, 150, 0.85, 0.85);
    std::move(given.begin(), given.end(), std::back_inserter(starts));
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
  GivenPivots given_;
  FitTask coarse_, fine_;
};

}  // namespace

SearchEffort search_effort(FitEffort effort) {
  switch (effort) {
    case FitEffort::quick:
      return {250, 180, 25, 6, 5, 1500, 40};
    case FitEffort::deep:
      return {16000, 12800, 480, 160, 24, 10000, 2000};
    default:
      return {1000, 800, 60, 20, 7, 4000, 150};
  }
}

CurveSearch search_curves(const ScaledTarget& target, const FitLimits& limits, const CurveFitOptions& options,
                          const Progress& progress) {
  return Search(target, limits, options, progress).run();
}

}  // namespace linkwright
