// Motions past random poses, beside the same least squares from random starts: which comes nearer, and in what time.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include "approximate/fit_parts.hpp"
#include "approximate/limit_refit.hpp"
#include "approximate/pose_result.hpp"
#include "approximate/pose_target.hpp"
#include "bench_task.hpp"
#include "linkwright/approximate/pose_fit.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright::bench::pose_draws_bench {
namespace {

// Of random numbers that nothing was tuned by: stays as it is, whatever comes out.
constexpr std::uint64_t fresh = 20'261'129;

// Sum of uniform numbers: of variance 1, all but normal, and the same everywhere.
double normal(testing::RandomFourBars& draw) {
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += draw.uniform(0, 1);
  return sum;
}

// Poses of a coupler over 1 to 3 radians of the input, or to its dead point. Noise: standard deviation of each
// coordinate and of the turn times the turning length, as a share of the origins' root mean square distance from their
// centroid, which is the turning length.
PoseTarget drawn_target(testing::RandomFourBars& draw, std::size_t count, double noise) {
  for (;;) {
    const FourBar bars = draw.four_bar();
    const Point offset{draw.uniform(-1, 1), draw.uniform(-1, 1)};
    PoseTarget target;
    for (const MotionState& state : motion_sweep(bars, {}, draw.uniform(1, 3), static_cast<int>(count)))
      target.poses.push_back(testing::coupler_pose(state.four_bar, offset, 0.4));
    target.turning_length = 1e-9;
    const double size = target.scale();
    constexpr double least_size = 0.1;  // of the linkage: an input at a dead point does not move at all
    if (target.poses.size() < count || size < least_size * bars.lengths().longest()) continue;
    target.turning_length = size;
    for (Pose& pose : target.poses) {
      pose.origin += noise * size * Point{normal(draw), normal(draw)};
      pose.angle += noise * normal(draw);
    }
    return target;
  }
}

/// Least squares from random linkages, each to its end; the best of them again, held to one side of their dead points.
class RandomStarts {
 public:
  RandomStarts(const PoseTarget& target, const PoseFitOptions& options, std::size_t count)
      : target_(target), options_(options), frame_(target) {
    std::vector<std::size_t> all(target.poses.size());
    for (std::size_t j = 0; j < all.size(); ++j) all[j] = j;
    scaled_ = frame_.scaled(target, all);
    task_ = {scaled_.poses, scaled_.weights, frame_.turning_length, limits_of(options, 1)};
    std::vector<BodyStart> starts = first_starts(count);
    finish(starts);
    std::vector<BodyStart> held;
    for (std::size_t k = 0; k < std::min(held_again, starts.size()); ++k)
      for (const BodyLinkage& linkage : {starts[k].linkage, swapped(starts[k].linkage)})
        held.push_back(held_to_branch(starts[k], linkage));
    finish(held);
    starts.insert(starts.end(), held.begin(), held.end());
    for (const BodyStart& start : starts) tell(start);
  }

  /// Least root mean square error: of linkages that can be driven through all poses within the limits, and of all.
  [[nodiscard]] double usable() const { return usable_; }
  [[nodiscard]] double any() const { return any_; }

 private:
  static constexpr std::size_t held_again = 60;

  Point drawn_point() {
    constexpr double reach = 3;
    const double radius = reach * std::sqrt(even()), angle = two_pi * even();
    return radius * direction(angle);
  }
  double even() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // Anywhere in a disc of three scales, links of lengths that suit.
  BodyLinkage drawn_linkage() {
    const Point a0 = drawn_point(), b0 = drawn_point(), za = drawn_point(), zb = drawn_point();
    const auto length = [&](Point center, Point body) {
      double square = 0;
      for (const BodyPose& pose : scaled_.poses) square += std::norm(carried(pose, body) - center);
      return std::sqrt(square / static_cast<double>(scaled_.poses.size()));
    };
    return {a0, b0, length(a0, za), length(b0, zb), za, zb};
  }

  // Of those that can take up all poses `count`, if a tenth of all do.
  std::vector<BodyStart> first_starts(std::size_t count) {
    std::vector<BodyStart> starts;
    for (std::size_t tried = 0; tried < 10 * count && starts.size() < count; ++tried) {
      BodyStart start{drawn_linkage(), scaled_.poses};
      if (close_states(task_, start)) starts.push_back(std::move(start));
    }
    return starts;
  }

  void finish(std::vector<BodyStart>& starts) const {
    constexpr int iterations = 150;
    for (BodyStart& start : starts) {
      evaluate(task_, start);
      improve(task_, start, iterations);
      refit_within_limits(task_, start);
      slide_to_nearest(task_, start);
    }
    sort_by_cost(starts);
  }

  // By the sign that more of its states have.
  [[nodiscard]] static BodyStart held_to_branch(const BodyStart& start, const BodyLinkage& linkage) {
    BodyStart held = start;
    held.linkage = linkage;
    held.converged = false;
    int sum = 0;
    for (const BodyPose& state : held.states) sum += transmission_sine(linkage, state) > 0 ? 1 : -1;
    held.branch = sum >= 0 ? 1 : -1;
    return held;
  }

  void tell(const BodyStart& start) {
    std::vector<BodyPose> states;
    for (const BodyPose& state : start.states) states.push_back(frame_.in_user_frame(state));
    const BodyLinkage linkage = frame_.in_user_frame(start.linkage);
    for (const BodyLinkage& l : {linkage, swapped(linkage)}) {
      const PoseFit fit = pose_fit_of(l, states, target_, options_);
      any_ = std::min(any_, fit.error.rms);
      if (fit.within_limits && fit.drive.no_defects(false)) usable_ = std::min(usable_, fit.error.rms);
    }
  }

  const PoseTarget& target_;
  const PoseFitOptions& options_;
  PoseFrame frame_;
  ScaledPoses scaled_;
  PoseFitTask task_{};
  std::mt19937_64 engine_{fresh};
  double usable_ = std::numeric_limits<double>::infinity(), any_ = usable_;
};

/// How often ours is nearer, as near to 1 %, or farther; where it finds none at all and the random starts do, that is
/// counted among the farther, too.
struct Tally {
  double better = 0, equal = 0, worse = 0, worst_ratio = 1, none = 0;

  void add(double ours, double theirs, double exact) {
    constexpr double alike = 1.01;
    ours = std::max(ours, exact);
    theirs = std::max(theirs, exact);
    if (ours == theirs || (ours <= alike * theirs && theirs <= alike * ours)) return void(equal += 1);
    if (ours < theirs) return void(better += 1);
    worse += 1;
    if (std::isfinite(ours)) worst_ratio = std::max(worst_ratio, ours / theirs);
    if (!std::isfinite(ours)) none += 1;
  }
  void tell(benchmark::State& state, const std::string& of) const {
    state.counters[of + "better"] = better;
    state.counters[of + "equal"] = equal;
    state.counters[of + "worse"] = worse;
    state.counters[of + "worst_ratio"] = worst_ratio;
    state.counters[of + "none"] = none;
  }
};

struct Times {
  double sum = 0, worst = 0;
  int count = 0;

  void add(double ms) {
    sum += ms;
    worst = std::max(worst, ms);
    ++count;
  }
  void tell(benchmark::State& state, const std::string& of) const {
    state.counters[of + "mean_ms"] = sum / count;
    state.counters[of + "worst_ms"] = worst;
  }
};

void compare(benchmark::State& state, const std::vector<PoseTarget>& targets, FitEffort effort) {
  constexpr std::size_t random_starts = 400;
  constexpr double exact = 1e-9;  // of the scale
  PoseFitOptions options;
  options.effort = effort;
  options.threads = 1;
  Tally usable, any;
  Times ours, theirs;
  double rms = 0, peer_rms = 0;
  for (auto _ : state)
    for (const PoseTarget& target : targets) {
      PoseFits found;
      ours.add(processor_ms([&] { found = fit_poses(target, options); }));
      std::optional<RandomStarts> random;
      theirs.add(processor_ms([&] { random.emplace(target, options, random_starts); }));
      rms = found.fits.empty() ? std::numeric_limits<double>::infinity() : found.fits.front().error.rms;
      peer_rms = random->usable();
      const double least = found.smallest_with_defects ? found.smallest_with_defects->error.rms : rms;
      usable.add(rms, peer_rms, exact * target.scale());
      any.add(std::min(rms, least), random->any(), exact * target.scale());
      rms /= target.scale();
      peer_rms /= target.scale();
    }
  usable.tell(state, "");
  any.tell(state, "with_defects_");
  ours.tell(state, "");
  theirs.tell(state, "random_");
  if (targets.size() > 1) return;
  state.counters["rms_over_scale"] = rms;
  state.counters["random_rms_over_scale"] = peer_rms;
}

std::vector<PoseTarget> drawn_targets(double noise) {
  constexpr int count = 30, fewest = 6, most = 25;
  testing::RandomFourBars draw(fresh + static_cast<std::uint64_t>(1000 * noise));
  std::vector<PoseTarget> targets;
  for (int k = 0; k < count; ++k)
    targets.push_back(drawn_target(draw, static_cast<std::size_t>(fewest + draw.below(most - fewest + 1)), noise));
  return targets;
}

std::vector<PoseTarget> sixty_poses() {
  testing::RandomFourBars draw(fresh);
  return {drawn_target(draw, 60, 0.02)};
}

const bool registered = [] {
  for (const FitEffort effort : {FitEffort::quick, FitEffort::standard, FitEffort::deep}) {
    const std::string of_effort = "/" + std::string(name(effort));
    const auto add = [&](const std::string& title, const std::vector<PoseTarget>& targets) {
      benchmark::RegisterBenchmark(("fit_drawn_poses/" + title + of_effort).c_str(),
                                   [=](benchmark::State& state) { compare(state, targets, effort); })
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
    };
    for (const auto& [title, noise] :
         {std::pair("exact", 0.0), {"noise_1", 0.01}, {"noise_5", 0.05}, {"noise_25", 0.25}})
      add(title, drawn_targets(noise));
    add("sixty_noise_2", sixty_poses());
  }
  return true;
}();

}  // namespace
}  // namespace linkwright::bench::pose_draws_bench
