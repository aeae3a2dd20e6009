#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "approximate/curve_least_squares.hpp"
#include "approximate/pose_least_squares.hpp"
#include "approximate/timed_least_squares.hpp"

namespace linkwright {

/// By how much each limit is broken, > 0 where it is; lengths, and sines.
struct LimitExcess {
  double longest, shortest, ratio, margin, turn, sine = 0, pivots = 0;
};
/// `least_sine`: of the transmission angle at the states, with the branch's sign; nothing where there is no branch.
[[nodiscard]] LimitExcess excess_of(const FitLimits& limits, const LinkLengths& lengths,
                                    const std::optional<double>& least_sine, Point a0, Point b0);
/// The largest of them, each as a share of its limit; 0 where all are kept.
[[nodiscard]] double broken_share(const FitLimits& limits, const LimitExcess& excess);
/// Limits that are broken set a little stricter.
[[nodiscard]] FitLimits stricter(FitLimits limits, const LimitExcess& excess);
/// A coordinate outside its range to the range's end, held there by its bit.
void hold_pivots(const Box& box, Point& a0, Point& b0, unsigned& held);

/// With the branch's sign, at the states; nothing where the start has none.
[[nodiscard]] std::optional<double> least_sine(const CurveStart& start);
/// The states onto the linkage; false where one does not get there.
[[nodiscard]] bool close_states(const FitTask& task, CurveStart& start);
[[nodiscard]] inline bool close_states(const TimedTask& task, TimedStart& start) { return place_states(task, start); }
/// Of a state from its target: what is to be least.
[[nodiscard]] double distance_at(const FitTask& task, const CurveStart& start, std::size_t j);

/// Its weight may be shifted.
[[nodiscard]] inline bool is_near(const FitTask& /*task*/, std::size_t /*j*/) { return true; }

[[nodiscard]] inline bool is_near(const PoseFitTask& task, std::size_t j) {
  return !std::binary_search(task.exact.begin(), task.exact.end(), j);
}
[[nodiscard]] std::optional<double> least_sine(const BodyStart& start);
[[nodiscard]] bool close_states(const PoseFitTask& task, BodyStart& start);
[[nodiscard]] double distance_at(const PoseFitTask& task, const BodyStart& start, std::size_t j);

template <class Start>
[[nodiscard]] LimitExcess excess_of(const FitLimits& limits, const Start& start) {
  return excess_of(limits, start.linkage.lengths(), least_sine(start), start.linkage.a0, start.linkage.b0);
}

/// By how much a linkage breaks its limits, as a share of each; 0 where it keeps them. Of the transmission angle the
/// sine, at the states, where the start has a branch.
template <class Start>
[[nodiscard]] double broken_share(const FitLimits& limits, const Start& start) {
  return broken_share(limits, excess_of(limits, start));
}

/// Hinges give way a little: limits that are broken are set a little stricter, pivots outside their window are moved to
/// its border and held there, and the rest is fitted again.
template <class Task, class Start>
void refit_within_limits(const Task& task, Start& start) {
  constexpr int rounds = 6, iterations = 60;
  constexpr double kept = 1e-9;
  Task stricter_task = task;
  for (int round = 0; round < rounds && broken_share(task.limits, start) > kept; ++round) {
    stricter_task.limits = stricter(stricter_task.limits, excess_of(task.limits, start));
    Start next = start;
    if (task.limits.ground) hold_pivots(*task.limits.ground, next.linkage.a0, next.linkage.b0, next.held);
    if (!close_states(task, next)) break;
    evaluate(stricter_task, next);
    next.converged = false;
    improve(stricter_task, next, iterations);
    start = std::move(next);
  }
  evaluate(task, start);
}

/// Of what a search began with, that which keeps the limits on its branch, as it is: a fit that is led back to its
/// limits may end a little beside them.
template <class Task, class Start>
[[nodiscard]] std::vector<Start> within_limits(const Task& task, const std::vector<Start>& given) {
  constexpr double kept = 1e-9;
  std::vector<Start> within;
  for (Start start : given) {
    slide_to_nearest(task, start);
    evaluate(task, start);
    if (start.branch != 0 && broken_share(task.limits, start) <= kept) within.push_back(std::move(start));
  }
  return within;
}

template <class Task, class Start>
[[nodiscard]] double largest_distance(const Task& task, const Start& start) {
  double largest = 0;
  for (std::size_t j = 0; j < start.states.size(); ++j)
    if (task.weights[j] > 0 && is_near(task, j)) largest = std::max(largest, distance_at(task, start, j));
  return largest;
}

/// Weights are shifted towards the largest distances until the largest is least (C. L. Lawson, 1961), at least that of
/// all that were met. The task's weights tell which targets count.
template <class Task, class Start>
void fit_least_largest(const Task& task, Start& start) {
  constexpr int rounds = 60, iterations = 4;
  constexpr double power = 0.7;
  std::vector<double> weights(task.weights.begin(), task.weights.end());
  Task shifted = task;
  shifted.weights = weights;
  Start best = start;
  double least = largest_distance(task, start);
  for (int round = 0; round < rounds && least > 0; ++round) {
    const double largest = largest_distance(task, start);
    double sum = 0, near = 0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
      if (!is_near(task, j)) continue;
      near += 1;
      weights[j] *= std::pow(distance_at(task, start, j) / largest, power);
      sum += weights[j];
    }
    if (!(sum > 0)) break;
    for (std::size_t j = 0; j < weights.size(); ++j)
      if (is_near(task, j)) weights[j] *= near / sum;
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
  slide_to_nearest(task, start);
}

}  // namespace linkwright
