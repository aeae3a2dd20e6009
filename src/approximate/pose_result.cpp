#include "approximate/pose_result.hpp"

#include <algorithm>
#include <cmath>

#include "approximate/drive_verdict.hpp"

namespace linkwright {
namespace {

std::vector<LoopState> loop_states(const BodyLinkage& linkage, std::span<const BodyPose> states) {
  std::vector<LoopState> all;
  for (const BodyPose& state : states) all.push_back(loop_state(linkage, state));
  return all;
}

bool hinges_within(const std::optional<PivotWindow>& window, Point one, Point other, double room) {
  if (!window) return true;
  const auto in = [&](Point p) { return distance_to(*window, Vector3{p.real(), p.imag(), 0}) <= room; };
  return in(one) && in(other);
}

bool keeps(const FitLimits& limits, const PivotWindows& windows, const BodyLinkage& linkage,
           std::span<const BodyPose> states, double scale) {
  const LinkLengths lengths = linkage.lengths();
  double least_sine = 1;
  for (const BodyPose& state : states) least_sine = std::min(least_sine, std::abs(transmission_sine(linkage, state)));
  const FourBar bars = four_bar(linkage, states.front());
  return lengths.longest() <= (1 + limit_slack) * limits.max_length &&
         lengths.shortest() >= (1 - limit_slack) * limits.min_length &&
         lengths.longest() <= (1 + limit_slack) * limits.max_link_ratio * lengths.shortest() &&
         least_sine >= limits.min_sine - limit_slack &&
         hinges_within(windows.ground, bars.input_fixed, bars.output_fixed, limit_slack * scale) &&
         hinges_within(windows.moving, bars.input_moving, bars.output_moving, 0);
}

std::vector<PoseState> told_states(const BodyLinkage& linkage, std::span<const BodyPose> states,
                                   std::span<const LoopState> loops, std::span<const double> turns,
                                   const PoseTarget& target) {
  std::vector<PoseState> told;
  const double first = std::arg(loops.front().e);
  for (std::size_t j = 0; j < states.size(); ++j) {
    const Pose& pose = target.poses[j];
    const double turn = turn_between(direction(pose.angle), states[j].axis);
    told.push_back({four_bar(linkage, states[j]),
                    {states[j].origin, pose.angle + turn},
                    first + turns[j],
                    std::abs(states[j].origin - pose.origin),
                    std::abs(turn)});
  }
  return told;
}

double square_error(const PoseState& state, double turning_length) {
  const double by_turn = turning_length * state.angle_error;
  return state.position_error * state.position_error + by_turn * by_turn;
}

PoseFitError told_error(const std::vector<PoseState>& states, const PoseTarget& target) {
  PoseFitError error;
  double weights = 0, largest = -1, positions = 0, angles = 0;
  std::size_t near = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const double square = square_error(states[j], target.turning_length);
    if (target.is_exact(j)) {
      error.exact_residual = std::max(error.exact_residual, std::sqrt(square));
      continue;
    }
    const double weight = target.weight(j);
    weights += weight;
    error.sum_of_squares += weight * square;
    if (!(weight > 0)) continue;
    ++near;
    positions += states[j].position_error * states[j].position_error;
    angles += states[j].angle_error * states[j].angle_error;
    error.position_max = std::max(error.position_max, states[j].position_error);
    error.angle_max = std::max(error.angle_max, states[j].angle_error);
    if (square <= largest) continue;
    largest = square;
    error.max_at = j;
  }
  if (near == 0) return error;
  error.rms = std::sqrt(error.sum_of_squares / weights);
  error.position_rms = std::sqrt(positions / static_cast<double>(near));
  error.angle_rms = std::sqrt(angles / static_cast<double>(near));
  return error;
}

}  // namespace

FitLimits limits_of(const PoseFitOptions& options, double scale) {
  FitLimits limits;
  limits.max_length = options.max_length * scale;
  limits.min_length = options.min_length * scale;
  limits.max_link_ratio = options.max_link_ratio;
  limits.min_sine = std::sin(options.min_transmission_angle);
  return limits;
}

PoseFit pose_fit_of(const BodyLinkage& linkage, std::span<const BodyPose> states, const PoseTarget& target,
                    const PoseFitOptions& options) {
  const double scale = target.scale();
  const FitLimits limits = limits_of(options, scale);
  const std::vector<LoopState> loops = loop_states(linkage, states);
  std::vector<double> squared;
  std::vector<Point> points;
  for (std::size_t j = 0; j < states.size(); ++j) {
    squared.push_back(square(move_between(body_pose(target.poses[j]), states[j], target.turning_length)));
    points.push_back(target.poses[j].origin);
  }
  const CircuitDrive drive = drive_along_circuit(coupler_linkage(linkage), loops, points, false,
                                                 order_noise(squared, scale), target.turning_length);
  PoseFit fit;
  fit.bars = four_bar(linkage, states.front());
  fit.drive = verdict(drive, CurveDriver::e, CurveDriver::g);
  fit.states = told_states(linkage, states, loops, input_turns(loops, drive.of(CurveDriver::e).turns), target);
  fit.error = told_error(fit.states, target);
  fit.min_transmission_angle = std::asin(std::min(drive.of(CurveDriver::e).min_sine, 1.0));
  fit.within_limits = keeps(limits, options.windows, linkage, states, scale);
  constexpr double at_limit = 1e-3;
  fit.at_length_limit = linkage.lengths().longest() >= (1 - at_limit) * limits.max_length;
  return fit;
}

}  // namespace linkwright
