#include "linkwright/approximate/pose_fit.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <variant>

#include "approximate/circuit_assignment.hpp"
#include "approximate/pose_result.hpp"
#include "approximate/pose_search.hpp"
#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

FitLimits scaled_limits(const PoseFitOptions& options, const PoseFrame& frame) {
  FitLimits limits = limits_of(options, 1);
  const Box* box = options.windows.ground ? std::get_if<Box>(&*options.windows.ground) : nullptr;
  if (!box) return limits;
  const Point low = frame.scaled(Point{box->x_low, box->y_low}), high = frame.scaled(Point{box->x_high, box->y_high});
  limits.ground = Box{low.real(), high.real(), low.imag(), high.imag()};
  return limits;
}

// The better of its two links as the input: free of defects, within the limits, the better transmitting.
PoseFit told(const BodyStart& start, const PoseTarget& target, const PoseFrame& frame, const PoseFitOptions& options) {
  const BodyLinkage linkage = frame.in_user_frame(start.linkage);
  std::vector<BodyPose> states;
  for (const BodyPose& state : start.states) states.push_back(frame.in_user_frame(state));
  PoseFit one = pose_fit_of(linkage, states, target, options);
  PoseFit other = pose_fit_of(swapped(linkage), states, target, options);
  const auto rank = [](const PoseFit& fit) {
    return std::tuple(fit.drive.no_defects(false) && fit.within_limits, fit.drive.no_defects(false),
                      fit.min_transmission_angle);
  };
  return rank(other) > rank(one) ? other : one;
}

std::vector<PoseFit> all_told(const std::vector<BodyStart>& minima, const PoseTarget& target, const PoseFrame& frame,
                              const PoseFitOptions& options) {
  std::vector<PoseFit> all(minima.size());
  parallel_for(all.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) all[k] = told(minima[k], target, frame, options);
  });
  return all;
}

double measured(const PoseFit& fit, const PoseTarget& target, FitMeasure measure) {
  if (measure == FitMeasure::least_squares) return fit.error.sum_of_squares;
  const PoseState& worst = fit.states[fit.error.max_at];
  return std::hypot(worst.position_error, target.turning_length * worst.angle_error);
}

bool same_linkage(const FourBar& a, const FourBar& b) {
  constexpr double apart = 1e-4;
  return farthest_pivot(a, b) <= apart * std::max(a.lengths().longest(), b.lengths().longest());
}

// Those that can be driven, and the best of those that cannot.
PoseFits sorted_out(std::vector<PoseFit> all, const PoseTarget& target, const PoseFitOptions& options) {
  std::stable_sort(all.begin(), all.end(), [&](const PoseFit& a, const PoseFit& b) {
    return measured(a, target, options.measure) < measured(b, target, options.measure);
  });
  PoseFits found;
  // What the poses asked for exactly miss by more than rounding belongs to no answer.
  constexpr double exact = 1e-7;
  const double most = exact * target.scale();
  for (PoseFit& fit : all) {
    if (!(fit.error.exact_residual <= most)) continue;
    if (!fit.drive.no_defects(false)) {
      if (!found.smallest_with_defects) found.smallest_with_defects = std::move(fit);
      continue;
    }
    if (!fit.within_limits || found.fits.size() == options.max_fits) continue;
    const auto is_listed = [&](const PoseFit& other) { return same_linkage(other.bars, fit.bars); };
    if (std::any_of(found.fits.begin(), found.fits.end(), is_listed)) continue;
    found.fits.push_back(std::move(fit));
  }
  return found;
}

// A linkage with a defect comes nearer than those without: one of these may yet be found from it.
bool is_kept_off_by_defects(const PoseFits& found, const PoseTarget& target, const PoseFitOptions& options) {
  if (found.fits.empty()) return true;
  constexpr double nearer = 0.98;
  return options.effort != FitEffort::quick && found.smallest_with_defects &&
         measured(*found.smallest_with_defects, target, options.measure) <
             nearer * measured(found.fits.front(), target, options.measure);
}

// What the search began with comes first where it is nearer than all that was found.
void prefer_given(const std::vector<BodyStart>& given, PoseFits& found, const PoseTarget& target,
                  const PoseFrame& frame, const PoseFitOptions& options) {
  const PoseFits as_given = sorted_out(all_told(given, target, frame, options), target, options);
  if (as_given.fits.empty()) return;
  const PoseFit& best = as_given.fits.front();
  if (!found.fits.empty() &&
      measured(found.fits.front(), target, options.measure) <= measured(best, target, options.measure))
    return;
  std::erase_if(found.fits, [&](const PoseFit& other) { return same_linkage(other.bars, best.bars); });
  found.fits.insert(found.fits.begin(), best);
  if (found.fits.size() > options.max_fits) found.fits.pop_back();
}

}  // namespace

PoseFits fit_poses(const PoseTarget& target, const PoseFitOptions& options, const Progress& progress) {
  constexpr std::size_t fewest = 3;  // below, a body can be anywhere
  require_pose_target(target, fewest);
  const PoseFrame frame(target);
  const FitLimits limits = scaled_limits(options, frame);
  const PoseSearch search = search_poses(target, frame, limits, options, progress);
  std::vector<PoseFit> all = all_told(search.minima, target, frame, options);
  PoseFits found = sorted_out(all, target, options);
  if (is_kept_off_by_defects(found, target, options) && !search.cancelled) {
    const Progress silent{{}, progress.cancelled};
    const auto again = fit_in_turn(search.minima, target, frame, limits, options, silent);
    for (PoseFit& fit : all_told(again, target, frame, options)) all.push_back(std::move(fit));
    found = sorted_out(std::move(all), target, options);
  }
  prefer_given(search.given, found, target, frame, options);
  found.counts = {search.dyads, search.starts, search.minima.size()};
  found.cancelled = search.cancelled;
  return found;
}

std::optional<PoseFit> compare_with_poses(const FourBar& bars, const Pose& body, const PoseTarget& target,
                                          const PoseFitOptions& options) {
  require_pose_target(target, 1);
  const LinkLengths lengths = bars.lengths();
  if (!(lengths.shortest() > 0) || !std::isfinite(lengths.perimeter()) || !is_finite(body.origin) ||
      !std::isfinite(body.angle))
    return std::nullopt;
  const BodyPose there = body_pose(body);
  const BodyLinkage linkage = body_linkage(bars, there);
  const CouplerCircuit circuit(coupler_linkage(linkage), loop_state(linkage, there), target.turning_length);
  if (circuit.states().size() < 3) return std::nullopt;
  std::vector<BodyPose> poses, states;
  for (const LoopState& state : circuit.states()) states.push_back(body_pose(linkage, state));
  for (const Pose& pose : target.poses) poses.push_back(body_pose(pose));
  // Exact poses decide, near ones by their weights.
  constexpr double exact = 1e6;
  const auto cost = [&](std::size_t state, std::size_t pose) {
    const double weight = target.is_exact(pose) ? exact : target.weight(pose);
    return weight * square(move_between(poses[pose], states[state], target.turning_length));
  };
  std::vector<BodyPose> nearest;
  for (const LoopState& state : states_in_turn(circuit, poses.size(), cost)) {
    const BodyPose& pose = poses[nearest.size()];
    nearest.push_back(nearest_state(linkage, body_pose(linkage, state), pose, target.turning_length));
  }
  return pose_fit_of(linkage, nearest, target, options);
}

}  // namespace linkwright
