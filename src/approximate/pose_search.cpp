#include "approximate/pose_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

#include "approximate/circuit_assignment.hpp"
#include "approximate/fit_parts.hpp"
#include "approximate/given_start.hpp"
#include "approximate/limit_refit.hpp"
#include "approximate/pose_pairs.hpp"

namespace linkwright {
namespace {

using Starts = std::vector<BodyStart>;

constexpr double first_factor = 1e2;  // of exact poses, beside near ones

// Quasi-random numbers in [0, 1): the k-th of a sequence that fills a cube evenly (M. Roberts, 2018: multiples of the
// powers of the real root of x⁹ = x + 1).
std::array<double, 8> strewn_numbers(std::size_t k) {
  constexpr double root = 1.0850702454914506;
  std::array<double, 8> numbers;
  double power = 1;
  for (double& number : numbers) {
    power /= root;
    const double multiple = 0.5 + power * static_cast<double>(k + 1);
    number = multiple - std::floor(multiple);
  }
  return numbers;
}

double rms_distance(std::span<const BodyPose> poses, Point body, Point center) {
  double square = 0;
  for (const BodyPose& pose : poses) square += std::norm(carried(pose, body) - center);
  return std::sqrt(square / static_cast<double>(poses.size()));
}

// Pivots anywhere in a disc of three scales, even by area, and links of lengths that suit.
BodyLinkage strewn_linkage(std::span<const BodyPose> poses, std::size_t k) {
  constexpr double reach = 3;
  const auto numbers = strewn_numbers(k);
  std::array<Point, 4> points;
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = reach * std::sqrt(numbers[2 * i]) * direction(two_pi * numbers[2 * i + 1]);
  return {points[0], points[1], rms_distance(poses, points[2], points[0]), rms_distance(poses, points[3], points[1]),
          points[2], points[3]};
}

// The sign that the transmission angle's sine keeps at all states; 0: none.
int kept_sign(const BodyLinkage& linkage, const BodyStart& start) {
  int sign = 0;
  for (const BodyPose& state : start.states) {
    const int here = transmission_sine(linkage, state) > 0 ? 1 : -1;
    if (sign != 0 && here != sign) return 0;
    sign = here;
  }
  return sign;
}

// The start held to its branch, by the link that can drive it; nothing where neither can.
std::optional<BodyStart> with_branch(const BodyStart& start) {
  BodyStart held = start;
  held.converged = false;
  held.branch = kept_sign(held.linkage, held);
  if (held.branch != 0) return held;
  held.linkage = swapped(held.linkage);
  held.branch = kept_sign(held.linkage, held);
  return held.branch != 0 ? std::optional(held) : std::nullopt;
}

bool same_linkage(const BodyLinkage& a, const BodyLinkage& b) {
  constexpr double apart = 1e-3;
  const auto near = [](Point p, Point q) { return std::abs(p - q) <= apart * (1 + std::abs(p)); };
  return near(a.a0, b.a0) && near(a.b0, b.b0) && near(a.za, b.za) && near(a.zb, b.zb);
}

// The first of each, with a branch and without.
void keep_distinct(Starts& starts) {
  Starts kept;
  for (BodyStart& start : starts) {
    const auto same = [&](const BodyStart& other) {
      return (other.branch != 0) == (start.branch != 0) &&
             (same_linkage(other.linkage, start.linkage) || same_linkage(other.linkage, swapped(start.linkage)));
    };
    if (std::none_of(kept.begin(), kept.end(), same)) kept.push_back(std::move(start));
  }
  starts = std::move(kept);
}

void keep_best(Starts& starts, std::size_t count) {
  sort_by_cost(starts);
  if (starts.size() > count) starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(count), starts.end());
}

void append(Starts& starts, Starts more) {
  starts.insert(starts.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

class PoseSearcher {
 public:
  PoseSearcher(const PoseTarget& target, const PoseFrame& frame, const FitLimits& limits, const PoseFitOptions& options,
               const Progress& progress)
      : options_(options),
        progress_(progress),
        effort_(pose_search_effort(options.effort)),
        frame_(frame),
        turning_length_(frame.turning_length),
        limits_(limits),
        coarse_(frame.scaled(target, chosen_poses(target, most_coarse))),
        fine_(frame.scaled(target, all_of(target))),
        coarse_weights_(coarse_.weights_with(first_factor)),
        fine_weights_(fine_.weights_with(first_factor)) {}

  PoseSearch run() {
    PoseSearch found;
    Starts starts = first_starts(found.dyads);
    found.starts = starts.size();
    improve_all(starts, task_of(coarse_, coarse_weights_), 4, 0, 0.3);
    keep_best(starts, effort_.middle);
    improve_all(starts, task_of(coarse_, coarse_weights_), 10, 0.3, 0.45);
    Starts clean = with_branches(starts);
    keep_best(starts, effort_.kept);
    improve_all(starts, task_of(coarse_, coarse_weights_), 150, 0.45, 0.6);
    append(starts, paired_again(starts));
    append(clean, with_branches(starts));
    sort_by_cost(clean);
    keep_distinct(clean);
    keep_best(clean, effort_.kept);
    improve_all(clean, task_of(coarse_, coarse_weights_), 150, 0.7, 0.8);
    append(starts, std::move(clean));
    const Starts given = given_starts();
    found.starts += given.size();
    found.given = within_limits(task_of(fine_, fine_weights_), given);
    append(starts, improved(given));
    found.minima = finished(std::move(starts));
    found.cancelled = progress_.is_cancelled();
    return found;
  }

  Starts run_in_turn(const Starts& minima) {
    constexpr std::size_t best = 10;
    Starts starts;
    for (std::size_t k = 0; k < std::min(best, minima.size()) && !progress_.is_cancelled(); ++k)
      for (const BodyLinkage& linkage : {minima[k].linkage, swapped(minima[k].linkage)})
        for (const int branch : {1, -1})
          if (auto start = in_turn(linkage, minima[k].states.front(), branch)) starts.push_back(*std::move(start));
    improve_all(starts, task_of(fine_, fine_weights_), 150, 0, 0.7);
    keep_best(starts, effort_.kept);
    return finished(std::move(starts));
  }

 private:
  static constexpr std::size_t most_coarse = 30;

  // Nothing where no such states exist on the circuit.
  [[nodiscard]] std::optional<BodyStart> in_turn(const BodyLinkage& linkage, const BodyPose& on_circuit,
                                                 int branch) const {
    const CouplerCircuit circuit(coupler_linkage(linkage), loop_state(linkage, on_circuit), turning_length_);
    if (circuit.states().size() < 3) return std::nullopt;
    std::vector<BodyPose> states;
    std::vector<bool> is_on_branch;
    for (const LoopState& state : circuit.states()) {
      states.push_back(body_pose(linkage, state));
      is_on_branch.push_back(branch * transmission_sine(linkage, states.back()) > 0);
    }
    const auto cost = [&](std::size_t state, std::size_t pose) {
      if (!is_on_branch[state]) return std::numeric_limits<double>::infinity();
      return fine_weights_[pose] * square(move_between(fine_.poses[pose], states[state], turning_length_));
    };
    BodyStart start{linkage, {}, branch};
    for (const LoopState& state : states_in_turn(circuit, fine_.poses.size(), cost)) {
      start.states.push_back(body_pose(linkage, state));
      if (!(branch * transmission_sine(linkage, start.states.back()) > 0)) return std::nullopt;
    }
    return start;
  }

  static std::vector<std::size_t> all_of(const PoseTarget& target) {
    std::vector<std::size_t> all(target.poses.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  [[nodiscard]] PoseFitTask task_of(const ScaledPoses& poses, std::span<const double> weights) const {
    return {poses.poses, weights, turning_length_, limits_, poses.exact};
  }

  [[nodiscard]] std::vector<DyadAtPoses> dyads() const {
    const PoseField field(coarse_.poses, coarse_weights_);
    std::vector<Point> points = field.minima();
    const std::vector<Point> valleys = field.valleys(effort_.valleys);
    points.insert(points.end(), valleys.begin(), valleys.end());
    std::vector<DyadAtPoses> found;
    for (const Point z : points) {
      const BodyDyad dyad = field.dyad(z);
      if (std::isfinite(dyad.error) && dyad.radius > 0) found.emplace_back(dyad, coarse_.poses, turning_length_);
    }
    return found;
  }

  // At the chosen poses; those that cannot take them up are left out.
  [[nodiscard]] Starts starts_from(std::span<const BodyLinkage> linkages) const {
    Starts starts;
    for (const BodyLinkage& linkage : linkages) {
      BodyStart start{linkage, coarse_.poses};
      if (close_states(task_of(coarse_, coarse_weights_), start)) starts.push_back(std::move(start));
    }
    return starts;
  }

  [[nodiscard]] std::vector<BodyLinkage> linkages_of(std::span<const DyadAtPoses> dyads, std::size_t count) const {
    std::vector<BodyLinkage> linkages;
    for (const PosePair& pair : best_pairs(dyads, coarse_weights_, limits_, count)) linkages.push_back(pair.linkage);
    return linkages;
  }

  [[nodiscard]] Starts first_starts(std::size_t& dyad_count) const {
    const std::vector<DyadAtPoses> found = dyads();
    dyad_count = found.size();
    std::vector<BodyLinkage> linkages = linkages_of(found, effort_.pairs);
    // Where few dyads are any good, linkages from anywhere take their places.
    const std::size_t strewn = effort_.strewn + (effort_.pairs - linkages.size()) / 2;
    for (std::size_t k = 0; k < strewn; ++k) linkages.push_back(strewn_linkage(coarse_.poses, k));
    return starts_from(linkages);
  }

  // Linkages that are given to begin with, on all poses: in turn on the branch on which they lie, and at the nearest
  // states, held to the branch and not.
  [[nodiscard]] Starts given_starts() const {
    const PoseFitTask task = task_of(fine_, fine_weights_);
    Starts starts;
    for (const PoseFitStart& given : options_.starts) {
      const FourBar bars = frame_.scaled(given.bars);
      if (!is_usable_start(bars)) continue;
      const BodyPose body = given.body ? frame_.scaled(*given.body) : fine_.poses.front();
      const BodyLinkage linkage = body_linkage(bars, body);
      const int branch = transmission_sine(linkage, body) < 0 ? -1 : 1;
      if (auto start = in_turn(linkage, body, branch)) starts.push_back(*std::move(start));
      BodyStart nearest{linkage, fine_.poses};
      if (!close_states(task, nearest)) continue;
      starts.push_back(nearest);
      nearest.branch = branch;
      starts.push_back(std::move(nearest));
    }
    return starts;
  }

  // Where they hold the body may not be known: their moving pivots are fitted first.
  [[nodiscard]] Starts improved(Starts starts) const {
    const PoseFitTask task = task_of(fine_, fine_weights_);
    constexpr unsigned all_but_moving_pivots = 0b111111;
    for_all_in_parts(starts.size(), options_.threads, progress_, 0.8, 0.8, [&](std::size_t k) {
      starts[k].held = all_but_moving_pivots;
      evaluate(task, starts[k]);
      improve(task, starts[k], 20);
      starts[k].held = 0;
      starts[k].converged = false;
      improve(task, starts[k], 150);
    });
    return starts;
  }

  void improve_all(Starts& starts, const PoseFitTask& task, int iterations, double from, double to) const {
    for_all_in_parts(starts.size(), options_.threads, progress_, from, to, [&](std::size_t k) {
      evaluate(task, starts[k]);
      improve(task, starts[k], iterations);
    });
    sort_by_cost(starts);
  }

  // The dyads of good linkages may go with each other as well.
  [[nodiscard]] Starts paired_again(const Starts& starts) const {
    std::vector<DyadAtPoses> dyads;
    for (const BodyStart& start : starts) {
      const BodyLinkage& l = start.linkage;
      dyads.emplace_back(BodyDyad{l.za, l.a0, l.a}, coarse_.poses, turning_length_);
      dyads.emplace_back(BodyDyad{l.zb, l.b0, l.b}, coarse_.poses, turning_length_);
    }
    Starts again = starts_from(linkages_of(dyads, 3 * effort_.kept));
    improve_all(again, task_of(coarse_, coarse_weights_), 8, 0.6, 0.65);
    keep_best(again, effort_.kept / 2);
    improve_all(again, task_of(coarse_, coarse_weights_), 150, 0.65, 0.7);
    return again;
  }

  [[nodiscard]] static Starts with_branches(const Starts& starts) {
    Starts clean;
    for (const BodyStart& start : starts)
      if (auto held = with_branch(start)) clean.push_back(*std::move(held));
    return clean;
  }

  // On all poses.
  [[nodiscard]] Starts finished(Starts starts) const {
    sort_by_cost(starts);
    keep_distinct(starts);
    spread(starts);
    PoseFitTask task = task_of(fine_, fine_weights_);
    improve_all(starts, task, 60, 0.8, 0.9);
    creep(starts, task);
    settle(starts, task, 0.93, 0.98);
    sort_by_cost(starts);
    Starts led = not_turning(starts);
    task.limits.grashof_margin = turning_margin;
    improve_all(led, task, 60, 0.98, 0.99);
    settle(led, task, 0.99, 1);
    append(starts, std::move(led));
    sort_by_cost(starts);
    keep_distinct(starts);
    return starts;
  }

  // Exact poses brought to rounding, limits kept.
  void settle(Starts& starts, PoseFitTask task, double from, double to) const {
    std::vector<double> weights = fine_weights_;
    task.weights = weights;
    for (const double factor : exact_factors()) {
      for (const std::size_t j : fine_.exact) weights[j] = factor;
      for (BodyStart& start : starts) start.converged = false;
      improve_all(starts, task, 40, from, from);
    }
    constexpr std::size_t best = 12;
    for_all_in_parts(starts.size(), options_.threads, progress_, from, to, [&](std::size_t k) {
      if (options_.measure == FitMeasure::least_largest && k < best) fit_least_largest(task, starts[k]);
      refit_within_limits(task, starts[k]);
      slide_to_nearest(task, starts[k]);
    });
  }

  // Between states on one side of the dead points the way may pass two of them. Where a link turns fully there are
  // fewer: the best that need not are fitted again by Grashof's condition.
  static constexpr double turning_margin = 0.003;  // of the scale
  [[nodiscard]] Starts not_turning(const Starts& starts) const {
    Starts found;
    for (const BodyStart& start : starts) {
      if (found.size() == effort_.kept) break;
      if (start.branch == 0 || grashof_excess(start.linkage.lengths()) >= turning_margin) continue;
      found.push_back(start);
      found.back().converged = false;
    }
    return found;
  }

  [[nodiscard]] std::vector<double> exact_factors() const {
    return fine_.exact.empty() ? std::vector<double>{} : std::vector<double>{1e4, 1e7, 1e10, 1e13};
  }

  // Starts at the chosen poses alone, to all.
  void spread(Starts& starts) const {
    Starts kept;
    for (BodyStart& start : starts) {
      if (start.states.size() < fine_.poses.size()) {
        start.states = fine_.poses;
        start.converged = false;
        if (!close_states(task_of(fine_, fine_weights_), start)) continue;
      }
      kept.push_back(std::move(start));
    }
    starts = std::move(kept);
  }

  // Near straight lines least squares creep along flat valleys: the best get longer.
  void creep(Starts& starts, const PoseFitTask& task) const {
    constexpr std::size_t best = 6;
    constexpr int iterations = 500;
    const std::size_t count = std::min(starts.size(), best);
    for_all_in_parts(count, options_.threads, progress_, 0.9, 0.93, [&](std::size_t k) {
      starts[k].converged = false;
      improve(task, starts[k], iterations);
    });
    sort_by_cost(starts);
  }

  const PoseFitOptions& options_;
  const Progress& progress_;
  PoseSearchEffort effort_;
  const PoseFrame& frame_;
  double turning_length_;
  FitLimits limits_;
  ScaledPoses coarse_, fine_;
  std::vector<double> coarse_weights_, fine_weights_;
};

}  // namespace

PoseSearchEffort pose_search_effort(FitEffort effort) {
  switch (effort) {
    case FitEffort::quick:
      return {120, 250, 0, 60, 20};
    case FitEffort::deep:
      return {600, 8000, 4000, 2500, 400};
    default:
      return {230, 1400, 0, 350, 60};
  }
}

PoseSearch search_poses(const PoseTarget& target, const PoseFrame& frame, const FitLimits& limits,
                        const PoseFitOptions& options, const Progress& progress) {
  return PoseSearcher(target, frame, limits, options, progress).run();
}

std::vector<BodyStart> fit_in_turn(const std::vector<BodyStart>& minima, const PoseTarget& target,
                                   const PoseFrame& frame, const FitLimits& limits, const PoseFitOptions& options,
                                   const Progress& progress) {
  return PoseSearcher(target, frame, limits, options, progress).run_in_turn(minima);
}

}  // namespace linkwright
