#include "approximate/limit_refit.hpp"

#include <array>

namespace linkwright {
namespace {

double outside(const std::optional<Box>& box, Point p) {
  if (!box) return 0;
  return std::max({box->x_low - p.real(), p.real() - box->x_high, box->y_low - p.imag(), p.imag() - box->y_high, 0.0});
}

}  // namespace

LimitExcess excess_of(const FitLimits& limits, const LinkLengths& lengths, const std::optional<double>& least_sine,
                      Point a0, Point b0) {
  return {lengths.longest() - limits.max_length,
          limits.min_length - lengths.shortest(),
          lengths.longest() / lengths.shortest() - limits.max_link_ratio,
          limits.grashof_margin - grashof_excess(lengths),
          limits.min_turn_sine > 0 ? limits.min_turn_sine - least_turn_sine(lengths) : 0,
          least_sine ? limits.min_sine - *least_sine : 0,
          std::max(outside(limits.ground, a0), outside(limits.ground, b0))};
}

double broken_share(const FitLimits& limits, const LimitExcess& excess) {
  const double length = std::max(excess.longest / limits.max_length, 0.0);
  return std::max(
      {length, limits.min_length > 0 ? excess.shortest / limits.min_length : 0, excess.ratio / limits.max_link_ratio,
       excess.margin / std::max(std::abs(limits.grashof_margin), 1e-12), excess.sine, excess.turn, excess.pivots, 0.0});
}

FitLimits stricter(FitLimits limits, const LimitExcess& excess) {
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

void hold_pivots(const Box& box, Point& a0, Point& b0, unsigned& held) {
  const std::array<Point*, 2> pivots = {&a0, &b0};
  for (std::size_t k = 0; k < 2; ++k) {
    const Point at = *pivots[k];
    const Point within{std::clamp(at.real(), box.x_low, box.x_high), std::clamp(at.imag(), box.y_low, box.y_high)};
    if ((held >> 2 * k & 3u) == 3u) continue;  // where it is asked for, or at a corner
    if (within.real() != at.real()) held |= 1u << 2 * k;
    if (within.imag() != at.imag()) held |= 2u << 2 * k;
    *pivots[k] = within;
  }
}

std::optional<double> least_sine(const CurveStart& start) {
  if (start.branch == 0) return std::nullopt;
  double least = 1;
  for (const LoopState& state : start.states)
    least = std::min(least, start.branch * cross(state.u, LoopGradient(start.linkage, state).g) / start.linkage.b);
  return least;
}

bool close_states(const FitTask& /*task*/, CurveStart& start) {
  bool closes = true;
  for (LoopState& state : start.states) closes = close_loop(start.linkage, state) && closes;
  return closes;
}

double distance_at(const FitTask& task, const CurveStart& start, std::size_t j) {
  return std::abs(traced_point(start.linkage, start.states[j]) - task.points[j]);
}

std::optional<double> least_sine(const BodyStart& start) {
  if (start.branch == 0) return std::nullopt;
  double least = 1;
  for (const BodyPose& state : start.states)
    least = std::min(least, start.branch * transmission_sine(start.linkage, state));
  return least;
}

bool close_states(const PoseFitTask& task, BodyStart& start) {
  const BodyClosing closing(start.linkage, task.turning_length);
  return std::all_of(start.states.begin(), start.states.end(), [&](BodyPose& state) { return closing.close(state); });
}

double distance_at(const PoseFitTask& task, const BodyStart& start, std::size_t j) {
  return std::sqrt(square(move_between(task.poses[j], start.states[j], task.turning_length)));
}

}  // namespace linkwright
