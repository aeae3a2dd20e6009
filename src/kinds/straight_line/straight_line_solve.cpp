#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analyses/analyses.hpp"
#include "linkwright/core/count_text.hpp"
#include "straight_line_kind.hpp"
#include "synthesis/linkage_search.hpp"
#include "synthesis/reason.hpp"
#include "synthesis/region_count.hpp"

namespace linkwright {
namespace {

std::int64_t whole_linkages(const Findings& found) {
  return found.counts.pairs - found.counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
}

// By the map, over the stroke that is asked for.
bool none_reaches_the_stroke(const StraightLineAnswer& answer) {
  const std::span<const float> deviation = answer.region.values(measures::deviation);
  for (std::size_t cell = 0; cell < deviation.size(); ++cell)
    if (answer.region.type(cell) != LinkageType::degenerate && std::isfinite(deviation[cell])) return false;
  return true;
}

// Of none of the linkages that a limit of the deviation alone keeps out: then none goes as far as the stroke.
bool none_goes_so_far(const StraightLineAnswer& answer) {
  return std::any_of(answer.relax.begin(), answer.relax.end(), [](const Relaxation& without) {
    return without.requirement == RequirementKind::max_deviation && !without.value;
  });
}

Notice nothing_meets(const StraightLineAnswer& answer) {
  const std::int64_t whole = whole_linkages(answer);
  Notice notice{
      "none_left_straight",
      fmt::format("None of the linkages of this case{} ({}) meets all requirements.{}",
                  is_complete(*answer.lines) ? "" : " looked at", grouped_text(whole), inside_text(answer, "linkages")),
      {{"count", static_cast<double>(whole)}}};
  if (!answer.relax.empty())
    notice.message += fmt::format(" {} is the most restrictive: without it {} would be left.",
                                  key(answer.relax.front().requirement), grouped_text(answer.relax.front().only_this));
  else if (answer.relax_together)
    notice.message += " " + joint_relaxation_text(*answer.relax_together);
  if (none_reaches_the_stroke(answer))
    notice.message += " None of them reaches the stroke: their points turn back before the ends of the stroke.";
  else if (none_goes_so_far(answer))
    notice.message += " These cannot meet it: their points turn back before the ends of the stroke.";
  return notice;
}

void state_what_was_found(StraightLineAnswer& answer) {
  const std::int64_t whole = whole_linkages(answer);
  if (whole == 0) {
    answer.status = SolutionStatus::no_solution;
    answer.reason = nothing_on_map(answer, answer.region);
  } else if (nothing_meets_requirements(answer)) {
    if (!std::isfinite(answer.requirements.max_deviation) && answer.relax_together &&
        std::count(answer.relax_together->requirements.begin(), answer.relax_together->requirements.end(),
                   RequirementKind::max_deviation) > 0)
      answer.relax_together.reset();  // nobody set it: the stroke is not reached
    answer.status = SolutionStatus::no_solution;
    answer.reason = nothing_meets(answer);
  } else {
    answer.reason = {
        "solved",
        fmt::format("All four-bars of the map: {}; meeting all requirements: {}.", grouped_text(whole),
                    grouped_text(answer.meeting_requirements)) +
            after_a_sentence(found_inside_text(answer)),
        {{"count", static_cast<double>(whole)}, {"meeting", static_cast<double>(answer.meeting_requirements)}}};
  }
}

// Larger is better, by what ranks the map.
double score_of(const StraightLineSolution& found, const StraightLineAnswer& answer) {
  return rank_of(answer.options.objective, straight_line_measures).score(line_cell(found.linkage, found.worth()));
}

// Its point has the contact that its case promises, and the triangles of its links confirm its path.
bool is_confirmed(const StraightLineSolution& made) {
  return made.verified_by_driving && made.contact.points >= promised_contact(made.task.given);
}

Notice where_nothing_is(const StraightLineFamily& family, MapPoint at, bool on_map) {
  const auto rows = family.range(Side::input), columns = family.range(Side::output);
  const std::string where = fmt::format("({:g}, {:g})", at.input, at.output);
  return {on_map ? "nothing_there" : "off_the_map",
          on_map ? fmt::format("There is no linkage at {} of the map: the equations have no real solution there, a "
                               "pivot is at infinity, or a link has no length.",
                               where)
                 : fmt::format("{} is off the map: its axes run from {:g} to {:g} and from {:g} to {:g}.", where,
                               rows[0], rows[1], columns[0], columns[1]),
          {{"input", at.input}, {"output", at.output}}};
}

Notice what_is_there(const StraightLineAnswer& answer, MapPoint at) {
  const auto meeting =
      std::count_if(answer.fails.begin(), answer.fails.end(), [](const auto& failed) { return failed.empty(); });
  const auto short_of_stroke =
      std::count_if(answer.linkages.begin(), answer.linkages.end(),
                    [](const StraightLineSolution& found) { return found.asks_stroke && !found.stroke; });
  const auto count = std::ssize(answer.linkages);
  std::string message = fmt::format("Linkages at ({:g}, {:g}) of the map: {}; meeting all requirements: {}.", at.input,
                                    at.output, count, meeting);
  if (short_of_stroke > 0)
    message += fmt::format(" Whose point turns back before the ends of the stroke: {}.", short_of_stroke);
  return {"picked_layers",
          message,
          {{"input", at.input},
           {"output", at.output},
           {"count", static_cast<double>(count)},
           {"meeting", static_cast<double>(meeting)}}};
}

struct FoundInLayer {
  StraightLineSolution linkage;
  std::vector<RequirementKind> failed;
};

// Of all layers at a place, best first.
std::vector<FoundInLayer> layers_at(const StraightLineAnswer& answer, MapPoint at) {
  const StraightLineFamily& family = *answer.lines;
  std::vector<FoundInLayer> all;
  for (int layer = 0; layer < family.layers(); ++layer) {
    const auto place = family.point_of({layer, {at.input, at.output}});
    if (!place) continue;
    auto made = make_straight_line(family, *place);
    if (!made) continue;
    made->place.at = {at.input, at.output};
    auto failed = failures_of(*made, answer.requirements);
    const auto of_tolerances = answer.added.failures_at(*place, answer.requirements);
    failed.insert(failed.end(), of_tolerances.begin(), of_tolerances.end());
    all.push_back({*std::move(made), std::move(failed)});
  }
  std::stable_sort(all.begin(), all.end(), [&](const FoundInLayer& a, const FoundInLayer& b) {
    return score_of(a.linkage, answer) > score_of(b.linkage, answer);
  });
  return all;
}

void list_layers(StraightLineAnswer& answer) {
  const MapPoint at = *answer.options.at;
  std::vector<FoundInLayer> all = layers_at(answer, at);
  for (FoundInLayer& found : all) {
    answer.linkages.push_back(std::move(found.linkage));
    answer.fails.push_back(std::move(found.failed));
  }
  const bool on_map = answer.lines->point_of({0, {at.input, at.output}}).has_value();
  answer.status = all.empty() ? SolutionStatus::no_solution : SolutionStatus::solved;
  answer.reason = all.empty() ? where_nothing_is(*answer.lines, at, on_map) : what_is_there(answer, at);
}

// Where nothing is left open there is no map to search: all that meet the requirements.
void list_all(StraightLineAnswer& answer) {
  for (FoundInLayer& found : layers_at(answer, {}))
    if (found.failed.empty() && found.linkage.defects.none() && std::ssize(answer.linkages) < answer.options.best)
      answer.linkages.push_back(std::move(found.linkage));
  state_what_was_found(answer);
}

// What is searched for is scaled to the stroke, and deviates as far as it may.
std::string way_out(const straight_cases::Search& wanted, const Requirements& requirements) {
  if (requirements.min_stroke > wanted.stroke)
    return fmt::format("The requirements ask for a usable length of {:g}: search for a stroke as long.",
                       requirements.min_stroke);
  if (requirements.max_deviation < wanted.deviation)
    return fmt::format("The requirements allow a deviation of {:g} only: search for a deviation as small.",
                       requirements.max_deviation);
  return "Allow longer links (max_length), a larger deviation, or more room for the pivots.";
}

Notice what_was_looked_for(const StraightLineSearchResult& search, const straight_cases::Search& wanted,
                           const Requirements& requirements) {
  const std::string drawn = grouped_text(search.drawn);
  if (search.interrupted)
    return {"lines_interrupted",
            fmt::format("Stopped early, after {} places of all maps: {}", drawn,
                        search.linkages.empty() ? "nothing is found so far."
                                                : "the best so far, measured but not improved to the end."),
            {{"count", static_cast<double>(search.drawn)}}};
  if (search.linkages.empty())
    return {"no_line_found",
            fmt::format("Of {} places of all maps none has a linkage that runs straight over {:g} to ±{:g} and meets "
                        "the requirements. {}",
                        drawn, wanted.stroke, wanted.deviation, way_out(wanted, requirements)),
            {{"count", static_cast<double>(search.drawn)}}};
  return {"lines_found",
          fmt::format("Looked at {} places of all maps; each linkage listed runs straight over {:g} to ±{:g}.", drawn,
                      wanted.stroke, wanted.deviation),
          {{"count", static_cast<double>(search.drawn)}}};
}

Answer search_all_cases(StraightLineAnswer answer, const straight_cases::Search& wanted, const Progress& progress) {
  const SynthesisOptions& options = answer.options;
  answer.options.line = {wanted.deviation, wanted.stroke, LineMeasure::strip};
  StraightLineSearchResult found =
      search_straight_lines(answer.task.line, wanted, answer.requirements,
                            {options.objective, std::max(options.best, 1), static_cast<std::uint64_t>(options.seed),
                             static_cast<double>(options.effort) / default_effort, options.region.threads},
                            progress);
  answer.reason = what_was_looked_for(found, wanted, answer.requirements);
  if (found.linkages.empty()) answer.status = SolutionStatus::no_solution;
  if (options.best > 0) answer.linkages = std::move(found.linkages);  // otherwise it is told only whether there are any
  found.linkages.clear();
  answer.search = std::move(found);
  return answer;
}

}  // namespace

Notice nothing_on_map(const StraightLineAnswer& known, const RegionMap& map) {
  const std::span<const float> valid = map.values(measures::valid);
  if (std::any_of(valid.begin(), valid.end(), [](float kind) { return kind == 2; }))
    return {"only_sliders",
            "Every linkage of this case has a slider in place of a link here. Widen the window, or change what is "
            "given.",
            {}};
  return no_straight_line(known.task);
}

Requirements with_default_length(Requirements wanted, const StraightLineTask& task) {
  if (!wanted.max_length) wanted.max_length = default_max_length * size_of(task);
  return wanted;
}

Notice no_straight_line(const StraightLineTask& task) {
  return {"no_straight_line",
          fmt::format("No linkage of the case {} has these numbers: its equations have no real solution. Change what "
                      "is given beside the line.",
                      name(task.given)),
          {{"case", std::string(name(task.given))}}};
}

StraightLineAnswer begin_answer(const StraightLineTask& task, const Requirements& requirements,
                                const SynthesisOptions& options, const Progress& /*progress*/) {
  StraightLineAnswer answer;
  answer.task = task;
  answer.characteristic_length = size_of(task);
  answer.requirements = with_default_length(requirements, task);
  answer.options = with_task_defaults(options, answer.characteristic_length);
  if (!std::holds_alternative<straight_cases::Search>(task.given))
    answer.lines = std::make_shared<StraightLineFamily>(task, options.line, options.window);
  return answer;
}

Result<Answer> solve_of_kind(const StraightLineTask& task, const Requirements& requirements,
                             const SynthesisOptions& options, const Progress& progress) {
  StraightLineAnswer answer = begin_answer(task, requirements, options);
  if (const auto* wanted = std::get_if<straight_cases::Search>(&task.given))
    return search_all_cases(std::move(answer), *wanted, progress);
  const StraightLineFamily& family = *answer.lines;
  const CountedRegion counted = count_region(answer, family, {options.region_samples, std::nullopt}, progress);
  if (options.at) {
    list_layers(answer);
  } else if (family.axis(Side::input).is_discrete()) {
    list_all(answer);
  } else {
    const Making<StraightLineSolution> making{
        [&](MapPoint place) { return make_straight_line(family, place); },
        [](const Cell& cell, const auto& made) { return cell.type == made.type && is_confirmed(made); }};
    auto best = best_linkages(family, making, answer, counted, progress);
    answer.linkages = std::move(best.linkages);
    if (!is_of_analysis(options.objective) && !options.pareto)
      std::stable_sort(answer.linkages.begin(), answer.linkages.end(),
                       [&](const StraightLineSolution& a, const StraightLineSolution& b) {
                         return score_of(a, answer) > score_of(b, answer);
                       });
    answer.left_out = best.left_out;
    state_what_was_found(answer);
  }
  progress(1);
  if (progress.is_cancelled()) return Error{"cancelled", "", "stopped before the answer was complete"};
  return Answer(std::move(answer));
}

void leave_out_unconfirmed(StraightLineAnswer& answer) {
  answer.left_out += static_cast<std::int64_t>(
      std::erase_if(answer.linkages, [](const StraightLineSolution& found) { return !is_confirmed(found); }));
  if (answer.left_out == 0) return;
  answer.warnings.push_back(
      {"linkages_left_out_straight",
       fmt::format(
           "Left out of the best: {}, so near a singular place of the case, a change point or a dead point that "
           "rounding decides how straight they run.",
           grouped_text(answer.left_out)),
       {{"count", static_cast<double>(answer.left_out)}}});
}

}  // namespace linkwright
