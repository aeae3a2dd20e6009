#include <algorithm>
#include <fmt/format.h>

#include "analyses/analyses.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "six_bar_kind.hpp"
#include "synthesis/picked_place.hpp"
#include "synthesis/reason.hpp"
#include "synthesis/region_count.hpp"

namespace linkwright {
namespace {

// The map's cells are driven through one by one, so it is coarser than that of four-bars.
int samples_of(const SynthesisOptions& options) {
  constexpr int four_bar_cells_to_a_cell = 4;
  return std::max(options.region_samples / four_bar_cells_to_a_cell, SynthesisOptions::min_samples);
}

Notice nothing_found(const SixBarAnswer& answer) {
  const std::int64_t whole =
      answer.counts.pairs - answer.counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0)
    return {"no_pair",
            "No two added links make a six-bar of this chain: in every pair a hinge is at infinity or a link has no "
            "length.",
            {}};
  if (answer.counts.defect_free == 0)
    return {
        "none_defect_free",
        fmt::format(
            "None of the six-bars looked at ({}), which guide the body through all poses, is free of defects. Move a "
            "hinge of the chain, join other bodies, or leave the chain out and let it be searched for.",
            grouped_text(whole)),
        {{"count", static_cast<double>(whole)}}};
  return {"none_left",
          fmt::format("None of the six-bars looked at that are free of defects ({}) meets all requirements.{}{}",
                      grouped_text(answer.counts.defect_free), inside_text(answer, "six-bars"),
                      answer.relax_together ? " " + joint_relaxation_text(*answer.relax_together) : ""),
          {{"count", static_cast<double>(answer.counts.defect_free)}}};
}

void evaluate(SixBarAnswer& answer) {
  const std::int64_t whole =
      answer.counts.pairs - answer.counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0) answer.status = SolutionStatus::no_solution;
  const bool none = answer.options.best > 0 ? answer.linkages.empty() : nothing_meets_requirements(answer);
  if (none) {
    answer.reason = nothing_found(answer);
    return;
  }
  answer.reason = {
      "solved",
      fmt::format("All six-bars that guide the body through all poses: {}; free of defects: {}; meeting all "
                  "requirements: {}.",
                  grouped_text(whole), grouped_text(answer.counts.defect_free),
                  grouped_text(answer.meeting_requirements)) +
          after_a_sentence(found_inside_text(answer)),
      {{"count", static_cast<double>(whole)},
       {"defect_free", static_cast<double>(answer.counts.defect_free)},
       {"meeting", static_cast<double>(answer.meeting_requirements)}}};
}

Error cancelled_map() { return {"cancelled", "", "stopped before the answer was complete"}; }

// The map leaves out the walk round the whole circuit.
std::optional<SixBarSolution> six_bar_at(const SixBarAnswer& answer, MapPoint place,
                                         std::vector<RequirementKind>& failed) {
  const auto member = answer.chain->member(place);
  const auto row = six_bar_row(answer.task.added);
  if (!member || !row) return std::nullopt;
  SixBarSolution found = solution_of(answer.task.poses, *answer.task.chain, *row, *member);
  const bool known = std::find(failed.begin(), failed.end(), RequirementKind::no_defects) != failed.end();
  if (answer.requirements.no_defects && !found.rating.drive.defects.none() && !known)
    failed.push_back(RequirementKind::no_defects);
  return found;
}

/// Some of the map's front, in its order.
std::vector<SixBarSolution> along_the_front(const SixBarAnswer& answer, const Progress& progress) {
  std::vector<SixBarSolution> found;
  for (const ParetoCell& cell : spread_over(answer.pareto, static_cast<std::size_t>(answer.options.best))) {
    if (progress.is_cancelled()) break;
    const MapPoint place = {answer.region.input_coordinates()[cell.row],
                            answer.region.output_coordinates()[cell.column]};
    std::vector<RequirementKind> failed;
    if (auto six_bar = six_bar_at(answer, place, failed); six_bar && failed.empty())
      found.push_back(*std::move(six_bar));
  }
  return found;
}

MapPoint cell_size(const ChainFamily& family, const RegionMap& map, const std::optional<MapWindow>& window) {
  const auto length = [&](Side side) {
    if (!window) return family.axis(side).coordinate_length();
    const auto [low, high] = window->of(side);
    return high - low;
  };
  return {length(Side::input) / static_cast<double>(map.rows()),
          length(Side::output) / static_cast<double>(map.columns())};
}

Result<Answer> solve_chain(SixBarAnswer answer, const Progress& progress) {
  if (!answer.chain) return Error{"out_of_reach", "task.chain", "the chain does not reach all poses"};
  const CountedRegion counted =
      count_region(answer, *answer.chain, {samples_of(answer.options), answer.options.window}, progress);
  const SynthesisOptions& options = answer.options;
  if (options.at) {
    list_what_is_there(answer, *answer.chain, [&](MapPoint place, std::vector<RequirementKind>& failed) {
      return six_bar_at(answer, place, failed);
    });
    return progress.is_cancelled() ? Result<Answer>(cancelled_map()) : Result<Answer>(Answer(std::move(answer)));
  }
  // Unlike four-bars' the two axes may have different lengths.
  std::vector<SearchMap> maps = counted.maps(answer.region);
  maps.front().step = cell_size(*answer.chain, answer.region, options.window);
  answer.linkages =
      options.pareto && answer.meeting_requirements > 0
          ? along_the_front(answer, progress)
          : best_six_bars(answer.task, *answer.chain, maps, answer.requirements,
                          {options.objective, options.best, options.region.threads, answer.added, options.window},
                          progress);
  if (progress.is_cancelled()) return cancelled_map();
  evaluate(answer);
  return Answer(std::move(answer));
}

Answer search_chain(SixBarAnswer answer, const Progress& progress) {
  const SynthesisOptions& options = answer.options;
  SixBarSearchResult found =
      search_six_bars(answer.task, answer.requirements, {options.objective, options.best, options.region.threads},
                      {static_cast<std::uint64_t>(options.seed), options.effort}, progress);
  answer.linkages = std::move(found.linkages);
  answer.reason = found.reason;
  if (found.reason.code != "searched") answer.status = SolutionStatus::no_solution;
  found.linkages.clear();
  answer.search = std::move(found);
  return answer;
}

}  // namespace

SixBarAnswer begin_answer(const SixBarTask& task, const Requirements& requirements, const SynthesisOptions& options,
                          const Progress& /*progress*/) {
  const PoseConditions conditions = pose_conditions(task.poses);
  SixBarAnswer answer;
  answer.task = task;
  answer.chain = ChainFamily::of(task);
  answer.pattern = pattern(task.poses);
  answer.condition = conditions.condition();
  answer.characteristic_length = conditions.frame.scale;
  answer.requirements = task.chain ? with_defaults(requirements, *task.chain) : requirements;
  answer.options = with_task_defaults(options, answer.characteristic_length);
  if (auto notice = points_notice(task.points)) answer.warnings.push_back(*std::move(notice));
  return answer;
}

Result<Answer> solve_of_kind(const SixBarTask& task, const Requirements& requirements, const SynthesisOptions& options,
                             const Progress& progress) {
  SixBarAnswer answer = begin_answer(task, requirements, options);
  return task.chain ? solve_chain(std::move(answer), progress) : search_chain(std::move(answer), progress);
}

}  // namespace linkwright
