#include "approximate/start_list.hpp"

#include <algorithm>
#include <cmath>

#include "approximate/limit_refit.hpp"

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
void append_distinct(const std::vector<ScannedPair>& pairs, bool clean, bool compact, std::size_t count,
                     std::vector<ScannedPair>& chosen) {
  std::vector<const ScannedPair*> taken;
  for (const ScannedPair& pair : pairs) {
    if (taken.size() == count) break;
    if ((pair.driver != 0) != clean || (clean && is_compact(pair.linkage) != compact)) continue;
    const auto same = [&](const ScannedPair* other) { return same_start(pair.linkage, other->linkage); };
    if (std::none_of(taken.begin(), taken.end(), same)) taken.push_back(&pair);
  }
  for (const ScannedPair* pair : taken) chosen.push_back(*pair);
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

}  // namespace

std::vector<ScannedPair> distinct_pairs(std::vector<ScannedPair> pairs, std::size_t count) {
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.score < b.score; });
  std::vector<ScannedPair> distinct;
  append_distinct(pairs, true, true, count / 4, distinct);
  append_distinct(pairs, true, false, count * 3 / 4 - distinct.size(), distinct);
  append_distinct(pairs, false, false, count - distinct.size(), distinct);
  return distinct;
}

std::vector<CurveStart> starts_of(const std::vector<ScannedPair>& pairs, std::span<const Point> chosen) {
  std::vector<CurveStart> starts;
  for (const ScannedPair& pair : pairs) {
    CurveStart start{pair.linkage, states_of(pair, chosen)};
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

FitTask task_of(const FitTask& task, const CurveStart& start) {
  FitTask own = task;
  if (start.branch != 0) return own;
  own.limits.grashof_margin = -FitLimits::unlimited;
  own.limits.min_turn_sine = 0;
  return own;
}

std::optional<CurveStart> with_same_input(const CurveStart& start) {
  constexpr double arm = 1e-6;
  CurveStart other = start;
  turn_to_swapped(other);
  if (std::abs(other.linkage.p) < arm) return std::nullopt;
  turn_to_cognate(other);
  turn_to_swapped(other);
  if (start.branch != 0) other.branch = branch_of(other);
  return other;
}

CurveStart kept_to_branch(CurveStart start) {
  start.branch = branch_of(start);
  return start;
}

CurveStart driven_by_output(CurveStart start) {
  turn_to_swapped(start);
  if (start.branch != 0) start.branch = branch_of(start);
  return start;
}

void turn_within_limits(const FitLimits& limits, CurveStart& start) {
  constexpr unsigned input_pivot = 0b11;  // it would be another
  if ((start.held & input_pivot) != 0 || broken_share(limits, start) == 0) return;
  auto other = with_same_input(start);
  if (other && broken_share(limits, *other) < broken_share(limits, start)) start = *std::move(other);
}

void keep_best(std::vector<CurveStart>& starts, std::size_t clean, std::size_t any) {
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

void keep_distinct(std::vector<CurveStart>& starts) {
  std::vector<CurveStart> kept;
  for (CurveStart& start : starts) {
    const auto same = [&](const CurveStart& other) {
      return (other.branch != 0) == (start.branch != 0) && same_curve(other.linkage, start.linkage);
    };
    if (std::none_of(kept.begin(), kept.end(), same)) kept.push_back(std::move(start));
  }
  starts = std::move(kept);
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

}  // namespace linkwright
