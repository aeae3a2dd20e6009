#include "pivot_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "arm_solver.hpp"
#include "core/uniform.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {
namespace {

Point middle_of(const Box& box) { return {(box.x_low + box.x_high) / 2, (box.y_low + box.y_high) / 2}; }

/// A ground pivot and an arm from there.
struct PivotAndArm {
  Point pivot;   ///< user's frame
  MapPoint arm;  ///< without a layer
  ArmRating rating{};
};

/// What trying a pivot showed.
struct PivotTrial {
  std::optional<PivotAndArm> best;
  std::int64_t arms = 0, meeting = 0;
};

class PivotSearch {
 public:
  PivotSearch(const PathTask& task, const PivotSearchOptions& options)
      : task_(task),
        options_(options),
        requirements_(
            with_default_lengths(options.requirements, arm_task(with_pivot(task, middle_of(*task.box))).frame.scale)),
        wishes_{CellJudge(requirements_, path_linkages, arm_measures), rank_of(options.objective, arm_measures),
                requirements_.no_defects} {}

  /// The best linkage of some arms; nothing where a point lies at the pivot.
  [[nodiscard]] PivotTrial trial(Point pivot, std::span<const MapPoint> arms) const;

  /// Moved to where random steps, shorter and shorter, find nothing better.
  [[nodiscard]] PivotAndArm refined(PivotAndArm here, std::uint64_t seed, const Progress& progress) const;

 private:
  [[nodiscard]] static PathTask with_pivot(PathTask task, Point pivot) {
    task.box.reset();
    task.pivots.input = pivot;
    return task;
  }

  PathTask task_;
  PivotSearchOptions options_;
  Requirements requirements_;
  ArmWishes wishes_;
};

PivotTrial PivotSearch::trial(Point pivot, std::span<const MapPoint> arms) const {
  PivotTrial trial;
  const PathTask task = with_pivot(task_, pivot);
  if (!mistakes_in(task).empty()) return trial;
  const ArmTask its_arms = arm_task(task);
  const auto choice = arm_choice(task, its_arms).choice;
  const ArmLayers layers(its_arms, *choice);
  std::vector<std::uint8_t> meets(arms.size(), 0);
  const auto take = [&](std::size_t tag, const ArmRating& rating) -> ArmLinkage* {
    if (rating.passes) meets[tag] = 1;
    if (!trial.best || rating.is_better_than(trial.best->rating)) trial.best = {pivot, arms[tag], rating};
    return nullptr;
  };
  ArmSolver solver(its_arms, layers, wishes_, requirements_.respect_direction, options_.simd);
  for (std::size_t i = 0; i < arms.size(); ++i)
    if (const auto here = choice->at(arms[i])) solver.add_all(i, arms[i], *here, take);
  solver.finish(take);
  trial.arms = static_cast<std::int64_t>(arms.size());
  trial.meeting = std::count(meets.begin(), meets.end(), 1);
  return trial;
}

PivotAndArm PivotSearch::refined(PivotAndArm here, std::uint64_t seed, const Progress& progress) const {
  constexpr int failures_a_length = 40, steps_a_length = 400;
  constexpr double first_length = 0.1, shortest = 3e-4;  // shares of the box, and of the arms' rectangle
  std::mt19937_64 random(seed);
  const Box& box = *task_.box;
  const auto stepped = [&](double from, double low, double high, double length) {
    return std::clamp(from + length * (high - low) * uniform(random, -1, 1), low, high);
  };
  for (double length = first_length; length > shortest && !progress.is_cancelled(); length /= 2)
    for (int steps = 0, failures = 0; steps < steps_a_length && failures < failures_a_length; ++steps, ++failures) {
      const double x = stepped(here.pivot.real(), box.x_low, box.x_high, length);
      const double y = stepped(here.pivot.imag(), box.y_low, box.y_high, length);
      const double reach = stepped(here.arm.input, 0, 1, length);
      const std::array<MapPoint, 1> arm = {{{reach, stepped(here.arm.output, 0, 1, length)}}};
      const PivotTrial there = trial({x, y}, arm);
      if (!there.best || !there.best->rating.is_better_than(here.rating)) continue;
      here = *there.best;
      failures = 0;
    }
  return here;
}

constexpr std::size_t arms_a_pivot = 16;

/// Some arms all over the rectangle.
std::array<MapPoint, arms_a_pivot> some_arms(std::mt19937_64& random) {
  constexpr int side = 4;
  std::array<MapPoint, arms_a_pivot> arms;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double reach = (i + uniform(random, 0, 1)) / side;
      arms[static_cast<std::size_t>(i * side + k)] = {reach, (k + uniform(random, 0, 1)) / side};
    }
  return arms;
}

bool is_better_pivot(const PivotAndArm& a, const PivotAndArm& b) { return a.rating.is_better_than(b.rating); }

}  // namespace

PivotSearchResult search_for_pivot(const PathTask& task, const PivotSearchOptions& options, const Progress& progress) {
  constexpr std::size_t chunk = 64, kept = 6;  // pivots between two looks at the progress; pivots that are refined
  constexpr double share_of_trials = 0.8;
  const PivotSearch search(task, options);
  const Box& box = *task.box;
  const std::size_t wanted = std::max<std::size_t>(1, static_cast<std::size_t>(options.effort) / arms_a_pivot);
  std::mt19937_64 random(options.seed);
  std::vector<PivotAndArm> held;
  PivotSearchResult result;
  for (std::size_t done = 0; done < wanted && !progress.is_cancelled(); done += chunk) {
    struct Drawn {
      Point pivot;
      std::array<MapPoint, arms_a_pivot> arms;
      PivotTrial trial;
    };
    std::vector<Drawn> drawn(std::min(chunk, wanted - done));
    for (Drawn& one : drawn) {
      const double x = uniform(random, box.x_low, box.x_high);
      one.pivot = {x, uniform(random, box.y_low, box.y_high)};
      one.arms = some_arms(random);
    }
    parallel_for(drawn.size(), options.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) drawn[i].trial = search.trial(drawn[i].pivot, drawn[i].arms);
    });
    for (const Drawn& one : drawn) {
      result.places += 1;
      result.arms += one.trial.arms;
      result.meeting += one.trial.meeting;
      if (one.trial.best) held.push_back(*one.trial.best);
    }
    std::stable_sort(held.begin(), held.end(), is_better_pivot);
    if (held.size() > kept) held.resize(kept);
    progress(share_of_trials * static_cast<double>(done + drawn.size()) / static_cast<double>(wanted));
  }
  parallel_for(held.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) held[i] = search.refined(held[i], options.seed + i + 1, progress);
  });
  std::stable_sort(held.begin(), held.end(), is_better_pivot);
  result.pivot = held.empty() ? middle_of(box) : held.front().pivot;
  result.meets = !held.empty() && held.front().rating.passes;
  return result;
}

}  // namespace linkwright
