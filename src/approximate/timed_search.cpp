#include "approximate/timed_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "approximate/fit_parts.hpp"
#include "approximate/given_start.hpp"
#include "approximate/limit_refit.hpp"
#include "approximate/start_list.hpp"
#include "approximate/timed_scan.hpp"

namespace linkwright {
namespace {

// Shapes of the scan, starts of the least squares, and those that go on to the end.
struct TimedEffort {
  std::size_t shapes, starts, last;
};
TimedEffort timed_effort(FitEffort effort) {
  switch (effort) {
    case FitEffort::quick:
      return {1200, 120, 24};
    case FitEffort::deep:
      return {48000, 1600, 240};
    default:
      return {5000, 400, 60};
  }
}

template <class Value>
std::vector<Value> at(const std::vector<Value>& all, const std::vector<std::size_t>& which) {
  std::vector<Value> some;
  for (const std::size_t j : which) some.push_back(all[j]);
  return some;
}

class TimedSearching {
 public:
  TimedSearching(const ScaledTarget& target, const CurveTiming& timing, const FitLimits& limits,
                 const CurveFitOptions& options, const Progress& progress)
      : target_(target),
        timing_(timing),
        options_(options),
        progress_(progress),
        effort_(timed_effort(options.effort)) {
    const double first = timing.absolute ? 0 : timing.input.front();
    for (const double input : timing.input) turns_.push_back(direction(input - first));
    chosen_points_ = target.chosen_points();
    chosen_weights_ = target.chosen_weights();
    chosen_turns_ = at(turns_, target.chosen);
    coarse_ = {{chosen_points_, chosen_weights_, limits}, chosen_turns_};
    fine_ = {{target.points, target.weights, limits}, turns_};
  }

  TimedSearch run() {
    TimedSearch found;
    std::vector<TimedStart> starts = starts_of_scan();
    found.shapes = effort_.shapes;
    found.starts = starts.size();
    improve_all(starts, coarse_, 6, 0.3, 0.5);
    starts.resize(std::min(starts.size(), 3 * effort_.last));
    improve_all(starts, coarse_, 20, 0.5, 0.65);
    keep_different(starts, [](const CouplerLinkage& a, const CouplerLinkage& b) { return same_start(a, b); });
    starts.resize(std::min(starts.size(), effort_.last));
    improve_all(starts, coarse_, 200, 0.65, 0.85);
    keep_different(starts, same_curve);
    spread(starts);
    std::vector<TimedStart> given = given_starts();
    found.given = within_limits(fine_, given);
    found.starts += given.size();
    std::move(given.begin(), given.end(), std::back_inserter(starts));
    improve_all(starts, fine_, 100, 0.85, 0.95);
    keep_to_limits(starts);
    keep_different(starts, same_curve);
    found.minima = std::move(starts);
    found.cancelled = progress_.is_cancelled();
    return found;
  }

 private:
  void for_all(std::size_t count, double from, double to, const std::function<void(std::size_t)>& body) {
    for_all_in_parts(count, options_.threads, progress_, from, to, body);
  }

  std::vector<TimedStart> starts_of_scan() {
    const std::vector<BarRatios> shapes = scanned_ratios(effort_.shapes, target_.closed);
    constexpr std::size_t at_once = 50;
    std::vector<std::vector<TimedCell>> found((shapes.size() + at_once - 1) / at_once);
    for_all(found.size(), 0, 0.3, [&](std::size_t k) {
      const std::size_t first = k * at_once, count = std::min(at_once, shapes.size() - first);
      found[k] = scan_ratios(coarse_, timing_.absolute, std::span(shapes).subspan(first, count), options_.simd);
    });
    std::vector<TimedCell> cells;
    for (const auto& here : found) cells.insert(cells.end(), here.begin(), here.end());
    std::stable_sort(cells.begin(), cells.end(),
                     [](const TimedCell& a, const TimedCell& b) { return a.squares < b.squares; });
    std::vector<TimedStart> starts;
    constexpr double near = 0.12, far = 0.6;
    constexpr std::size_t most_far = 80, looked_at = 4000;
    const std::size_t far_starts = std::min(effort_.starts / 2, most_far);
    append_starts(cells, near, effort_.starts - far_starts, starts);
    append_starts(std::span(cells).first(std::min(cells.size(), looked_at)), far, effort_.starts, starts);
    return starts;
  }

  // Up to a number, the best first, each `apart` from those before: the basin of the best is crowded.
  void append_starts(std::span<const TimedCell> cells, double apart, std::size_t most,
                     std::vector<TimedStart>& starts) const {
    for (const TimedCell& cell : cells) {
      if (starts.size() >= most) return;
      auto start = timed_start(coarse_, timing_.absolute, cell);
      if (!start) continue;
      const auto same = [&](const TimedStart& other) { return same_start(other.linkage, start->linkage, apart); };
      if (std::none_of(starts.begin(), starts.end(), same)) starts.push_back(*std::move(start));
    }
  }

  // Two of the curve's linkages have an input that turns alike, from different datums.
  void turn_to_better_cognate(const TimedTask& task, TimedStart& start) const {
    if (timing_.absolute) return;
    turn_within_limits(task.limits, start);
    start.take_datum(task);
  }

  void improve_all(std::vector<TimedStart>& starts, const TimedTask& task, int iterations, double from, double to) {
    for_all(starts.size(), from, to, [&](std::size_t k) {
      TimedStart& start = starts[k];
      start.converged = false;
      turn_to_better_cognate(task, start);
      evaluate(task, start);
      improve(task, start, iterations);
    });
    sort_timed(starts);
  }

  static void sort_timed(std::vector<TimedStart>& starts) {
    std::stable_sort(starts.begin(), starts.end(),
                     [](const TimedStart& a, const TimedStart& b) { return a.cost() < b.cost(); });
  }

  // The first of those that are the same.
  static void keep_different(std::vector<TimedStart>& starts,
                             bool (*are_same)(const CouplerLinkage&, const CouplerLinkage&)) {
    std::vector<TimedStart> kept;
    for (TimedStart& start : starts) {
      const auto same = [&](const TimedStart& other) { return are_same(other.linkage, start.linkage); };
      if (std::none_of(kept.begin(), kept.end(), same)) kept.push_back(std::move(start));
    }
    starts = std::move(kept);
  }

  void spread(std::vector<TimedStart>& starts) const {
    std::erase_if(starts, [&](TimedStart& start) { return !place_states(fine_, start); });
  }

  // Linkages that are given to begin with, in both senses of the input.
  [[nodiscard]] std::vector<TimedStart> given_starts() const {
    std::vector<TimedStart> given;
    for (const TracingFourBar& linkage : options_.starts) {
      const TracingFourBar scaled = target_.scaled_linkage(linkage);
      if (!is_usable_start(scaled.bars) || !is_finite(scaled.point)) continue;
      const LoopState first = loop_state(scaled);
      TimedStart start;
      start.linkage = coupler_linkage(scaled);
      start.branch = cross(first.u, LoopGradient(start.linkage, first).g) < 0 ? -1 : 1;
      if (timing_.absolute) start.held |= TimedStart::hold_datum;
      for (const bool reversed : {false, true}) {
        start.reversed = reversed;
        start.states = {first};
        if (!timing_.absolute) start.take_datum(fine_);
        if (place_states(fine_, start)) given.push_back(start);
      }
    }
    return given;
  }

  void keep_to_limits(std::vector<TimedStart>& starts) {
    constexpr std::size_t best = 12;
    for_all(starts.size(), 0.95, 1, [&](std::size_t k) {
      TimedStart& start = starts[k];
      if (options_.measure == FitMeasure::least_largest && k < best) fit_least_largest(fine_, start);
      refit_within_limits(fine_, start);
    });
    sort_timed(starts);
  }

  const ScaledTarget& target_;
  const CurveTiming& timing_;
  const CurveFitOptions& options_;
  const Progress& progress_;
  TimedEffort effort_;
  std::vector<Point> turns_, chosen_points_, chosen_turns_;
  std::vector<double> chosen_weights_;
  TimedTask coarse_, fine_;
};

}  // namespace

TimedSearch search_timed(const ScaledTarget& target, const CurveTiming& timing, const FitLimits& limits,
                         const CurveFitOptions& options, const Progress& progress) {
  return TimedSearching(target, timing, limits, options, progress).run();
}

}  // namespace linkwright
