#include "six_bar_answer.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/count_text.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {
namespace {

// The map's cells are driven through one by one, so it is coarser than that of four-bars.
int samples_of(const SynthesisOptions& options) {
  constexpr int four_bar_cells_to_a_cell = 4;
  return std::max(options.region_samples / four_bar_cells_to_a_cell, SynthesisOptions::least_samples);
}

Notice nothing_found(const Solution& solution) {
  const std::int64_t whole =
      solution.counts.pairs - solution.counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0)
    return {"no_pair",
            "No two added links make a six-bar of this chain: in every pair a hinge is at infinity or a link has no "
            "length.",
            {}};
  if (solution.counts.defect_free == 0)
    return {"none_defect_free",
            fmt::format("None of the six-bars that guide the body through all poses ({}) is free of defects. Move a "
                        "hinge of the chain, join other bodies, or leave the chain out and let it be searched for.",
                        grouped_text(whole)),
            {{"count", static_cast<double>(whole)}}};
  return {"none_left",
          fmt::format("None of the six-bars free of defects ({}) meets all requirements.{}",
                      grouped_text(solution.counts.defect_free),
                      solution.relax_together ? " " + joint_relaxation_text(*solution.relax_together) : ""),
          {{"count", static_cast<double>(solution.counts.defect_free)}}};
}

void judge(Solution& solution) {
  const std::int64_t whole =
      solution.counts.pairs - solution.counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0) solution.status = SolutionStatus::no_solution;
  const bool none = solution.options.best > 0 ? solution.six_bars.empty() : solution.meeting_requirements == 0;
  if (none) {
    solution.reason = nothing_found(solution);
    return;
  }
  solution.reason = {
      "solved",
      fmt::format("All six-bars that guide the body through all poses: {}; free of defects: {}; meeting all "
                  "requirements: {}.",
                  grouped_text(whole), grouped_text(solution.counts.defect_free),
                  grouped_text(solution.meeting_requirements)),
      {{"count", static_cast<double>(whole)},
       {"defect_free", static_cast<double>(solution.counts.defect_free)},
       {"meeting", static_cast<double>(solution.meeting_requirements)}}};
}

Result<Solution> solve_chain(const SixBarTask& task, Solution solution, const Progress& progress) {
  solution.chain = ChainFamily::of(task);
  if (!solution.chain) return Error{"out_of_reach", "task.chain", "the chain does not reach all poses"};
  const ChainFamily& family = *solution.chain;
  const SynthesisOptions& options = solution.options;
  const auto samples = [&](Side side) { return family.samples(side, samples_of(options), options.spacing); };
  family.classify(solution.region, samples(Side::input), samples(Side::output), solution.requirements.respect_direction,
                  options.region, progress);
  if (progress.is_cancelled()) return Error{"cancelled", "", "stopped before the answer was complete"};
  solution.counts = solution.region.counts();
  const RequirementFilter filter = filter_of(family, solution.region, solution.requirements);
  const RequirementCensus census = filter.census(progress);
  solution.meeting_requirements = census.meeting;
  if (census.meeting == 0) solution.relax = filter.relaxations(census, progress);
  if (solution.relax.empty()) solution.relax_together = census.joint_relaxation();
  solution.six_bars = best_six_bars(task, family, solution.region, solution.requirements,
                                    {options.objective, options.best, options.region.threads}, progress);
  if (progress.is_cancelled()) return Error{"cancelled", "", "stopped before the answer was complete"};
  judge(solution);
  return solution;
}

Solution search_chain(const SixBarTask& task, Solution solution, const Progress& progress) {
  const SynthesisOptions& options = solution.options;
  SixBarSearchResult found =
      search_six_bars(task, solution.requirements, {options.objective, options.best, options.region.threads},
                      {static_cast<std::uint64_t>(options.seed), options.effort}, progress);
  solution.six_bars = std::move(found.linkages);
  solution.reason = found.reason;
  if (found.reason.code != "searched") solution.status = SolutionStatus::no_solution;
  found.linkages.clear();
  solution.search = std::move(found);
  return solution;
}

}  // namespace

Result<Solution> solve_six_bars(const SixBarTask& task, const Requirements& requirements,
                                const SynthesisOptions& options, const Progress& progress) {
  Solution solution;
  solution.given.pattern = pattern(task.poses);
  solution.given.conditions = pose_conditions(task.poses);
  solution.options = options;
  if (!task.chain) {
    solution.requirements = requirements;
    return search_chain(task, std::move(solution), progress);
  }
  solution.given.size = task.chain->size();
  solution.requirements = with_defaults(requirements, *task.chain);
  return solve_chain(task, std::move(solution), progress);
}

}  // namespace linkwright
