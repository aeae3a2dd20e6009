#include "linkwright/planar/motion_synthesis.hpp"

#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "linkwright/core/tolerance.hpp"
#include "planar/degenerate_task.hpp"
#include "planar/linkage_search.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 3> status_names = {"solved", "no_solution", "degenerate"};
constexpr std::array<std::string_view, 2> spacing_names = {"coordinate", "arc_length"};

void append(std::vector<Error>& all, std::vector<Error> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Coordinates of one axis of the region.
std::vector<double> axis_coordinates(const BurmesterCurve& curve, const SynthesisOptions& options,
                                     const std::array<double, 2> RegionWindow::*side) {
  if (!options.window) return curve.samples(options.region_samples, options.spacing);
  const auto [low, high] = *options.window.*side;
  std::vector<double> coordinates;
  for (int i = 0; i < options.region_samples; ++i)
    coordinates.push_back(low + (high - low) * (i + 0.5) / options.region_samples);
  return coordinates;
}

std::vector<Dyad> dyads_at(const BurmesterCurve& curve, const std::vector<double>& coordinates) {
  std::vector<Dyad> dyads;
  dyads.reserve(coordinates.size());
  for (const double tau : coordinates) dyads.push_back(curve.dyad(tau));
  return dyads;
}

RegionMap region_of(const MotionTask& task, const MotionSolution& solution, const Progress& progress) {
  const WorkingFrame& frame = solution.conditions.frame;
  const auto poses = frame.to_working(task.poses);
  const bool respect = solution.requirements.respect_direction;
  const SynthesisOptions& options = solution.options;
  const RegionAxis input(dyads_at(*solution.curve, axis_coordinates(*solution.curve, options, &RegionWindow::input)),
                         poses, respect);
  if (!options.window) return RegionMap(input, input, frame.scale, options.region, progress);
  const RegionAxis output(dyads_at(*solution.curve, axis_coordinates(*solution.curve, options, &RegionWindow::output)),
                          poses, respect);
  return RegionMap(input, output, frame.scale, options.region, progress);
}

// Groups of parallel poses, in words: "1 and 3", "1, 2 and 4".
std::vector<std::string> parallel_poses(const MotionTask& task) {
  std::vector<std::string> groups;
  std::vector<bool> told(task.poses.size(), false);
  for (std::size_t i = 0; i < task.poses.size(); ++i) {
    std::vector<std::size_t> group = {i + 1};
    for (std::size_t j = i + 1; j < task.poses.size(); ++j) {
      if (told[i] || !are_parallel(task.poses[i].pose, task.poses[j].pose)) continue;
      group.push_back(j + 1);
      told[j] = true;
    }
    if (group.size() == 1) continue;
    const std::size_t last = group.back();
    group.pop_back();
    groups.push_back(fmt::format("{} and {}", fmt::join(group, ", "), last));
  }
  return groups;
}

void warn(MotionSolution& solution, const MotionTask& task) {
  if (solution.conditions.condition() > tolerance::ill_conditioned)
    solution.warnings.push_back(
        {"ill_conditioned",
         fmt::format(
             "The poses are so close that rounding shows (condition {:.1e}); replace poses that lie close together by "
             "one pose with derivatives (direction of travel, curvature).",
             solution.conditions.condition())});
  for (const auto& group : parallel_poses(task))
    solution.warnings.push_back(
        {"parallel_poses", fmt::format("Poses {} are parallel: their poles lie at infinity. This is fine.", group)});
}

std::string percent(std::int64_t part, std::int64_t whole) {
  const double share = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part < whole && share > 99) return "over 99 %";
  return share < 1 ? "under 1 %" : fmt::format("{:.0f} %", share);
}

std::string nothing_defect_free(const RegionCounts& counts) {
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  std::vector<std::string> causes;
  const auto blame = [&](std::int64_t cells, std::string_view what) {
    if (cells > 0) causes.push_back(fmt::format("{} {}", percent(cells, whole), what));
  };
  blame(counts.circuit, "need taking apart (circuit)");
  blame(counts.branch - counts.circuit, "lock between two poses (branch)");
  blame(counts.order, "visit them in another order");
  return fmt::format(
      "{} four-bars pass through all poses and none is free of defects: {}. Try another order of the poses, allow a "
      "defect (no_defects: false), or move a pose.",
      whole, fmt::join(causes, ", "));
}

std::string nothing_left(const MotionSolution& solution) {
  std::string sentence =
      fmt::format("{} four-bars are free of defects, and none meets all requirements.", solution.counts.defect_free);
  if (solution.relax.empty()) return sentence + " No single requirement is to blame: relax two or more.";
  const Relaxation& dearest = solution.relax.front();
  return sentence +
         fmt::format(" {} costs most: without it {} would be left.", key(dearest.requirement), dearest.only_this);
}

void judge(MotionSolution& solution) {
  const RegionCounts& counts = solution.counts;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0) {
    solution.status = SolutionStatus::no_solution;
    solution.reason =
        "No pair of side links makes a four-bar: in every pair a pivot is at infinity or a link has no length.";
  } else if (counts.defect_free == 0 && solution.requirements.no_defects) {
    solution.reason = nothing_defect_free(counts);
  } else if (solution.meeting_requirements == 0) {
    solution.reason = nothing_left(solution);
  } else {
    solution.reason =
        fmt::format("{} four-bars pass through all poses; {} are free of defects; {} meet all requirements.", whole,
                    counts.defect_free, solution.meeting_requirements);
  }
}

}  // namespace

std::string_view name(SolutionStatus status) { return status_names[static_cast<std::size_t>(status)]; }
std::string_view name(Spacing spacing) { return spacing_names[static_cast<std::size_t>(spacing)]; }

std::vector<Error> mistakes_in(const SynthesisOptions& options) {
  std::vector<Error> found;
  if (options.region_samples < SynthesisOptions::least_samples ||
      options.region_samples > SynthesisOptions::most_samples)
    found.push_back({"out_of_range", "options.region_samples",
                     fmt::format("the region takes {} to {} samples a side; 400 is usual",
                                 SynthesisOptions::least_samples, SynthesisOptions::most_samples)});
  if (options.best < 0 || options.best > SynthesisOptions::most_best)
    found.push_back(
        {"out_of_range", "options.best",
         fmt::format("the number of linkages to return lies between 0 and {}", SynthesisOptions::most_best)});
  if (options.window)
    for (const auto& [low, high] : {options.window->input, options.window->output})
      if (!(std::isfinite(low) && std::isfinite(high) && low < high))
        found.push_back(
            {"out_of_range", "options.window", "each interval of the window is [low, high] in τ with low below high"});
  return found;
}

Result<MotionSolution> solve_motion(const MotionTask& task, const Requirements& requirements,
                                    const SynthesisOptions& options, const Progress& progress) {
  std::vector<Error> mistakes = mistakes_in(task);
  append(mistakes, mistakes_in(requirements));
  append(mistakes, mistakes_in(options));
  if (!mistakes.empty()) return mistakes;

  MotionSolution solution;
  solution.pattern = pattern(task.poses);
  solution.conditions = pose_conditions(task.poses);
  const WorkingFrame& frame = solution.conditions.frame;
  solution.requirements = requirements;
  if (!requirements.max_length) solution.requirements.max_length = default_max_length * frame.scale;
  solution.options = options;
  solution.curve = std::make_shared<const BurmesterCurve>(solution.conditions);
  for (const Dyad& dyad : dyads_at(*solution.curve, solution.curve->samples(options.region_samples, options.spacing)))
    solution.samples.push_back(frame.to_user(dyad));
  if (const auto degeneracy = degeneracy_of(task, solution.conditions, *solution.curve)) {
    solution.status = SolutionStatus::degenerate;
    solution.reason = *degeneracy;
    return solution;
  }

  warn(solution, task);
  progress(0.1);
  solution.region = region_of(task, solution, progress);
  progress(0.6);
  solution.counts = solution.region.counts();
  const RequirementFilter filter(solution.region, solution.requirements, frame.origin, frame.scale);
  const RequirementCensus census = filter.census();
  solution.meeting_requirements = census.meeting;
  if (census.meeting == 0) solution.relax = filter.relaxations(census);
  progress(0.7);
  solution.linkages = best_linkages(task, solution, filter, progress);
  if (progress.is_cancelled()) return Error{"cancelled", "", "stopped before the answer was complete"};
  judge(solution);
  progress(1);
  return solution;
}

}  // namespace linkwright
