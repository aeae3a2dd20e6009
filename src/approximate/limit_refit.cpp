#include "approximate/limit_refit.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

// By how much each limit is broken, > 0 where it is; lengths, and a sine.
struct Excess {
  double longest, shortest, ratio, margin, turn, sine = 0;
};

Excess excess_of(const FitLimits& limits, const CurveStart& start) {
  const LinkLengths lengths = start.linkage.lengths();
  Excess excess{lengths.longest() - limits.max_length, limits.min_length - lengths.shortest(),
                lengths.longest() / lengths.shortest() - limits.max_link_ratio,
                limits.grashof_margin - grashof_excess(lengths),
                limits.min_turn_sine > 0 ? limits.min_turn_sine - least_turn_sine(lengths) : 0};
  if (start.branch == 0) return excess;
  excess.sine = -1;
  for (const LoopState& state : start.states) {
    const double sine = cross(state.u, LoopGradient(start.linkage, state).g) / start.linkage.b;
    excess.sine = std::max(excess.sine, limits.min_sine - start.branch * sine);
  }
  return excess;
}

double outside(const std::optional<Box>& box, Point p) {
  if (!box) return 0;
  return std::max({box->x_low - p.real(), p.real() - box->x_high, box->y_low - p.imag(), p.imag() - box->y_high, 0.0});
}

FitLimits stricter(FitLimits limits, const Excess& excess) {
  limits.max_length -= std::max(excess.longest, 0.0);
  limits.min_length += std::max(excess.shortest, 0.0);
  limits.max_link_ratio -= std::max(excess.ratio, 0.0);
  limits.grashof_margin += std::max(excess.margin, 0.0);
  constexpr double most = 0.999;
  limits.min_turn_sine =
      std::min(limits.min_turn_sine + std::max(excess.turn, 0.0), std::max(limits.min_turn_sine, most));
  limits.min_sine += std::max(excess.sine, 0.0);
  return limits;
}

// Coordinates outside the window, to its border.
void hold_pivots(const Box& box, CurveStart& start) {
  CouplerLinkage& linkage = start.linkage;
  const std::array<Point*, 2> pivots = {&linkage.a0, &linkage.b0};
  for (std::size_t k = 0; k < 2; ++k) {
    const Point at = *pivots[k];
    const Point within{std::clamp(at.real(), box.x_low, box.x_high), std::clamp(at.imag(), box.y_low, box.y_high)};
    if ((start.held >> 2 * k & 3u) == 3u) continue;  // where it is asked for, or at a corner
    if (within.real() != at.real()) start.held |= 1u << 2 * k;
    if (within.imag() != at.imag()) start.held |= 2u << 2 * k;
    *pivots[k] = within;
  }
}

// The states follow the linkage; false where they cannot.
bool settle(const FitTask& /*task*/, CurveStart& start) {
  bool closes = true;
  for (LoopState& state : start.states) closes = close_loop(start.linkage, state) && closes;
  return closes;
}
bool settle(const TimedTask& task, TimedStart& start) { return place_states(task, start); }

double largest_distance(const FitTask& task, const CurveStart& start) {
  double largest = 0;
  for (std::size_t j = 0; j < start.states.size(); ++j)
    if (task.weights[j] > 0)
      largest = std::max(largest, std::abs(traced_point(start.linkage, start.states[j]) - task.points[j]));
  return largest;
}

template <class Task, class Start>
void refit(const Task& task, Start& start) {
  constexpr int rounds = 6, iterations = 60;
  constexpr double kept = 1e-9;
  Task stricter_task = task;
  for (int round = 0; round < rounds && broken_share(task.limits, start) > kept; ++round) {
    stricter_task.limits = stricter(stricter_task.limits, excess_of(task.limits, start));
    Start next = start;
    if (task.limits.ground) hold_pivots(*task.limits.ground, next);
    if (!settle(task, next)) break;
    evaluate(stricter_task, next);
    next.converged = false;
    improve(stricter_task, next, iterations);
    start = std::move(next);
  }
  evaluate(task, start);
}

template <class Task, class Start>
void shift_weights(const Task& task, Start& start) {
  constexpr int rounds = 60, iterations = 4;
  constexpr double power = 0.7;
  std::vector<double> weights(task.weights.begin(), task.weights.end());
  Task shifted = task;
  shifted.weights = weights;
  Start best = start;
  double least = largest_distance(task, start);
  for (int round = 0; round < rounds && least > 0; ++round) {
    const double largest = largest_distance(task, start);
    double sum = 0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
      const double distance = std::abs(traced_point(start.linkage, start.states[j]) - task.points[j]);
      weights[j] *= std::pow(distance / largest, power);
      sum += weights[j];
    }
    if (!(sum > 0)) break;
    for (double& weight : weights) weight *= static_cast<double>(weights.size()) / sum;
    start.converged = false;
    evaluate(shifted, start);
    improve(shifted, start, iterations);
    const double here = largest_distance(task, start);
    if (here < least && broken_share(task.limits, start) <= broken_share(task.limits, best) + 1e-6) {
      least = here;
      best = start;
    }
  }
  start = std::move(best);
}

}  // namespace

double broken_share(const FitLimits& limits, const CurveStart& start) {
  const Excess excess = excess_of(limits, start);
  const double length = std::max(excess.longest / limits.max_length, 0.0);
  const double pivots = std::max(outside(limits.ground, start.linkage.a0), outside(limits.ground, start.linkage.b0));
  return std::max(
      {length, limits.min_length > 0 ? excess.shortest / limits.min_length : 0, excess.ratio / limits.max_link_ratio,
       excess.margin / std::max(std::abs(limits.grashof_margin), 1e-12), excess.sine, excess.turn, pivots, 0.0});
}

void refit_within_limits(const FitTask& task, CurveStart& start) { refit(task, start); }
void refit_within_limits(const TimedTask& task, TimedStart& start) { refit(task, start); }

void fit_least_largest(const FitTask& task, CurveStart& start) {
  shift_weights(task, start);
  slide_to_nearest(task, start);
}
void fit_least_largest(const TimedTask& task, TimedStart& start) {
  shift_weights(task, start);
  evaluate(task, start);
}

}  // namespace linkwright
