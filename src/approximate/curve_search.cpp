#include "approximate/curve_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "approximate/limit_refit.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

double log_ratio(double a, double b) { return std::abs(std::log(a / b)); }

// As starts: what one of them leads to, the other does.
bool same_start(const CouplerLinkage& a, const CouplerLinkage& b) {
  constexpr double apart = 0.12;
  const double size = 1 + std::abs(a.a0);
  if (std::abs(a.a0 - b.a0) > apart * size) return false;
  if (std::abs(a.b0 - b.b0) > apart * (1 + std::abs(a.b0))) return false;
  return log_ratio(a.a, b.a) + log_ratio(a.b, b.b) + log_ratio(a.h, b.h) < apart;
}

// The best that are not the same start, up to `count`; pairs by ascending score.
void append_distinct(const std::vector<DyadPair>& pairs, bool clean, bool compact, std::size_t count,
                     std::vector<DyadPair>& chosen) {
  std::vector<const DyadPair*> taken;
  for (const DyadPair& pair : pairs) {
    if (taken.size() == count) break;
    if ((pair.driver != 0) != clean || (clean && is_compact(pair.linkage) != compact)) continue;
    const auto same = [&](const DyadPair* other) { return same_start(pair.linkage, other->linkage); };
    if (std::none_of(taken.begin(), taken.end(), same)) taken.push_back(&pair);
  }
  for (const DyadPair* pair : taken) chosen.push_back(*pair);
}

void turn_to_cognate(CurveStart& start) {
  for (LoopState& state : start.states) state = cognate(start.linkage, state);
  start.linkage = cognate(start.linkage);
}

void turn_to_swapped(CurveStart& start) {
  for (LoopState& state : start.states) state = swapped(start.linkage, state);
  start.linkage = swapped(start.linkage);
}

// Turned to the realisation whose input is the driver.
void turn_to_driver(char driver, CurveStart& start) {
  if (driver == 'u') turn_to_cognate(start);
  if (driver == 'g') turn_to_swapped(start);
}

int branch_of(const CurveStart& start) {
  int sum = 0;
  for (const LoopState& state : start.states) sum += cross(state.u, LoopGradient(start.linkage, state).g) > 0 ? 1 : -1;
  return sum >= 0 ? 1 : -1;
}

// Two of the curve's linkages have an input that turns as this one's does: the one that is farther within the limits.
void turn_within_limits(const FitLimits& limits, CurveStart& start) {
  constexpr double arm = 1e-6;
  if (broken_share(limits, start) == 0) return;
  CurveStart other = start;
  turn_to_swapped(other);
  if (std::abs(other.linkage.p) < arm) return;
  turn_to_cognate(other);
  turn_to_swapped(other);
  if (start.branch != 0) other.branch = branch_of(other);
  if (broken_share(limits, other) < broken_share(limits, start)) start = std::move(other);
}

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
    std::vector<CurveStart> starts = starts_of(scanned_pairs());
    found.places = effort_.places;
    found.starts = starts.size();
    improve_all(starts, coarse_, 4, 0.4, 0.5);
    keep_best(starts, 2 * starts.size() / 5, 2 * starts.size() / 5);
    improve_all(starts, coarse_, 12, 0.5, 0.65);
    keep_best(starts, effort_.clean, effort_.any);
    improve_all(starts, coarse_, 150, 0.65, 0.85);
    keep_distinct(starts);
    spread_to_all_points(starts);
    improve_all(starts, fine_, 60, 0.85, 0.95);
    creep(starts);
    keep_to_limits(starts);
    keep_distinct(starts);
    found.minima = std::move(starts);
    found.cancelled = progress_.is_cancelled();
    return found;
  }

 private:
  // Each index by itself, in parts between which progress is told.
  void for_all(std::size_t count, double from, double to, const std::function<void(std::size_t)>& body) {
    constexpr std::size_t parts = 8;
    for (std::size_t part = 0; part < parts && !progress_.is_cancelled(); ++part) {
      const std::size_t begin = count * part / parts, end = count * (part + 1) / parts;
      parallel_for(end - begin, options_.threads, [&](std::size_t low, std::size_t high) {
        for (std::size_t k = begin + low; k < begin + high && !progress_.is_cancelled(); ++k) body(k);
      });
      progress_(from + (to - from) * static_cast<double>(part + 1) / static_cast<double>(parts));
    }
  }

  std::vector<DyadPair> scanned_pairs() {
    const std::vector<Point> places = pivot_places(effort_.places, limits_.ground);
    std::vector<std::vector<DyadPair>> at(places.size());
    for_all(places.size(), 0, 0.4, [&](std::size_t k) {
      at[k] = scan_pivot(target_, chosen_, chosen_weights_, places[k], limits_.max_length, options_.simd);
    });
    std::vector<DyadPair> pairs;
    for (const auto& here : at) pairs.insert(pairs.end(), here.begin(), here.end());
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.score < b.score; });
    std::vector<DyadPair> distinct;
    append_distinct(pairs, true, true, effort_.starts / 4, distinct);
    append_distinct(pairs, true, false, effort_.starts * 3 / 4 - distinct.size(), distinct);
    append_distinct(pairs, false, false, effort_.starts - distinct.size(), distinct);
    return distinct;
  }

  std::vector<CurveStart> starts_of(const std::vector<DyadPair>& pairs) {
    std::vector<CurveStart> starts;
    for (const DyadPair& pair : pairs) {
      CurveStart start{pair.linkage, states_of(pair, chosen_)};
      bool closes = true;
      for (LoopState& state : start.states) closes = closes && close_loop(start.linkage, state);
      if (!closes) continue;
      if (pair.driver != 0) {
        turn_to_driver(pair.driver, start);
        start.branch = branch_of(start);
      }
      starts.push_back(std::move(start));
    }
    return starts;
  }

  // A linkage with defects is held to lengths and windows alone.
  FitTask task_of(const FitTask& task, const CurveStart& start) const {
    FitTask own = task;
    if (start.branch == 0) own.limits.grashof_margin = -FitLimits::unlimited;
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

  // Of those with a driver a third is kept for compact ones.
  static void keep_best(std::vector<CurveStart>& starts, std::size_t clean, std::size_t any) {
    std::size_t compact = 0;
    for (const CurveStart& start : starts) compact += start.branch != 0 && is_compact(start.linkage) ? 1 : 0;
    compact = std::min(compact, clean / 3);
    clean -= compact;
    std::vector<CurveStart> kept;
    for (CurveStart& start : starts) {
      const bool takes_compact = start.branch != 0 && is_compact(start.linkage) && compact > 0;
      std::size_t& left = start.branch == 0 ? any : takes_compact ? compact : clean;
      if (left == 0) continue;
      --left;
      kept.push_back(std::move(start));
    }
    starts = std::move(kept);
  }

  static void keep_distinct(std::vector<CurveStart>& starts) {
    std::vector<CurveStart> kept;
    for (CurveStart& start : starts) {
      const auto same = [&](const CurveStart& other) {
        return (other.branch != 0) == (start.branch != 0) && same_curve(other.linkage, start.linkage);
      };
      if (std::none_of(kept.begin(), kept.end(), same)) kept.push_back(std::move(start));
    }
    starts = std::move(kept);
  }

  // States at the other points begin between those at the chosen ones.
  void spread_to_all_points(std::vector<CurveStart>& starts) {
    if (target_.chosen.size() == target_.points.size()) return;
    std::vector<CurveStart> kept;
    for (CurveStart& start : starts) {
      start.converged = false;
      if (spread(start)) kept.push_back(std::move(start));
    }
    starts = std::move(kept);
  }

  bool spread(CurveStart& start) const {
    const std::vector<LoopState> coarse = start.states;
    start.states.resize(target_.points.size());
    bool closes = true;
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      const std::size_t from = target_.chosen[k];
      const bool is_last = k + 1 == coarse.size();
      if (is_last && !target_.closed) {
        start.states[from] = coarse[k];
        break;
      }
      const std::size_t to = is_last ? target_.points.size() + target_.chosen[0] : target_.chosen[k + 1];
      closes = closes && fill_between(start, from, to, coarse[k], coarse[(k + 1) % coarse.size()]);
    }
    return closes;
  }

  bool fill_between(CurveStart& start, std::size_t from, std::size_t to, const LoopState& first,
                    const LoopState& last) const {
    const std::size_t n = target_.points.size();
    const auto along = [&](std::size_t j) { return std::abs(target_.points[(j + 1) % n] - target_.points[j % n]); };
    double whole = 0, gone = 0;
    for (std::size_t j = from; j < to; ++j) whole += along(j);
    const auto between = [](Point a, Point b, double share) {
      const Point mixed = (1 - share) * a + share * b;
      return std::norm(mixed) > 0 ? mixed / std::abs(mixed) : a;
    };
    bool closes = true;
    for (std::size_t j = from; j < to; ++j) {
      const double share = whole > 0 ? gone / whole : 0;
      LoopState state{between(first.e, last.e, share), between(first.u, last.u, share)};
      closes = close_loop(start.linkage, state) && closes;
      start.states[j % n] = state;
      gone += along(j);
    }
    return closes;
  }

  // Near circles and straight lines least squares creep along flat valleys: the best get longer.
  void creep(std::vector<CurveStart>& starts) {
    std::size_t far = 8, compact = 6;
    std::vector<CurveStart> creeping, others;
    for (CurveStart& start : starts) {
      std::size_t& left = is_compact(start.linkage) ? compact : far;
      const bool goes_on = start.branch != 0 && left > 0;
      if (goes_on) --left;
      start.converged = false;
      (goes_on ? creeping : others).push_back(std::move(start));
    }
    improve_all(creeping, fine_, 600, 0.95, 0.98);
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

  static void sort_by_cost(std::vector<CurveStart>& starts) {
    const auto cheaper = [](const CurveStart& a, const CurveStart& b) { return a.cost() < b.cost(); };
    std::stable_sort(starts.begin(), starts.end(), cheaper);
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
      return {350, 160, 14, 5};
    case FitEffort::deep:
      return {22400, 12800, 480, 160};
    default:
      return {1400, 800, 60, 20};
  }
}

bool same_curve(const CouplerLinkage& a, const CouplerLinkage& b) {
  constexpr double apart = 1e-2;
  const std::array<Point, 3> one = {a.a0, a.b0, third_pivot(a)};
  std::array<Point, 3> other = {b.a0, b.b0, third_pivot(b)};
  for (const Point pivot : one) {
    const auto nearest = std::min_element(
        other.begin(), other.end(), [&](Point p, Point q) { return std::norm(p - pivot) < std::norm(q - pivot); });
    if (!(std::abs(*nearest - pivot) <= apart * (1 + std::abs(pivot)))) return false;
  }
  return true;
}

CurveSearch search_curves(const ScaledTarget& target, const FitLimits& limits, const CurveFitOptions& options,
                          const Progress& progress) {
  return Search(target, limits, options, progress).run();
}

}  // namespace linkwright
