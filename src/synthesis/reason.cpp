#include "reason.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "linkwright/core/count_text.hpp"

namespace linkwright {
namespace {

std::string percent(std::int64_t part, std::int64_t whole) {
  const double share = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part < whole && share > 99) return "over 99 %";
  return share < 1 ? "under 1 %" : fmt::format("{:.0f} %", share);
}

// Of a map that is a sample it says so.
std::string_view looked_at(const ReasonFacts& facts) { return facts.is_complete ? "" : " looked at"; }

Notice nothing_defect_free(const Findings& answer, const TaskWords& words, const ReasonFacts& facts) {
  const RegionCounts& counts = answer.counts;
  const bool directed = answer.requirements.respect_direction && facts.has_directions;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  std::vector<std::string> causes;
  const auto blame = [&](std::int64_t cells, std::string_view what) {
    if (cells > 0) causes.push_back(fmt::format("{} {}", percent(cells, whole), what));
  };
  blame(counts.circuit, "cannot be reached without reassembly (circuit)");
  blame(counts.branch - counts.circuit, words.lock);
  blame(counts.order, directed ? fmt::format("{}, or against a direction", words.order) : std::string(words.order));
  return {"none_defect_free",
          fmt::format("None of the {}{} ({}) is free of defects: {}. ", words.four_bars, looked_at(facts),
                      grouped_text(whole), fmt::join(causes, ", ")) +
              fmt::format(fmt::runtime(words.ways_out),
                          directed ? "turn a direction round or let none count (respect_direction: false), " : ""),
          {{"count", static_cast<double>(whole)}}};
}

// Why no linkage is left, by what is known of the places of its hinges.
std::string nothing_left_text(const Findings& answer, const TaskWords& words, const ReasonFacts& facts) {
  if (const std::string inside = inside_text(answer, words.linkages); !inside.empty())
    return inside.substr(1) + facts.missed;
  const RegionCounts& counts = answer.counts;
  const bool may_have_defects = !answer.requirements.no_defects;
  const std::int64_t count = may_have_defects
                                 ? counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)]
                                 : counts.defect_free;
  return fmt::format("None of the {}{}{} ({}) meets all requirements.", words.linkages, looked_at(facts),
                     may_have_defects ? "" : " that are free of defects", grouped_text(count)) +
         facts.missed;
}

Notice nothing_left(const Findings& answer, const TaskWords& words, const ReasonFacts& facts) {
  const bool is_empty = answer.inside && answer.inside->is_empty;
  const bool is_inside = answer.inside && answer.inside->looked_at > 0;
  const std::int64_t count = is_inside ? answer.inside->looked_at : answer.counts.defect_free;
  Notice notice{is_empty    ? "windows_empty"
                : is_inside ? "none_inside"
                            : "none_left",
                nothing_left_text(answer, words, facts),
                {{"count", static_cast<double>(count)}}};
  if (!answer.relax.empty()) {
    const Relaxation& dearest = answer.relax.front();
    notice.message += fmt::format(" {} is the most restrictive: without it {} would be left.", key(dearest.requirement),
                                  grouped_text(dearest.only_this));
  } else if (answer.relax_together) {
    notice.message += " " + joint_relaxation_text(*answer.relax_together);
  }
  return notice;
}

}  // namespace

bool is_complete(const LinkageFamily& family) {
  return family.axis(Side::input).is_discrete() && family.axis(Side::output).is_discrete();
}

std::string after_a_sentence(const std::string& text) { return text.empty() ? "" : " " + text; }

std::string inside_text(const Findings& found, std::string_view linkages) {
  if (!found.inside || found.inside->meeting > 0) return "";
  if (found.inside->is_empty)
    return fmt::format(
        " None of the {} has all its hinges inside the windows for them: no grounded link on the curves "
        "has both of its own there.",
        linkages);
  return fmt::format(" None of the {} {} looked at inside the windows for hinges meets the other requirements.",
                     grouped_text(found.inside->looked_at), linkages);
}

std::string found_inside_text(const Findings& found) {
  if (!found.inside || found.inside->meeting == 0 || found.meeting_requirements > 0) return "";
  return fmt::format(
      "Between the cells of the map, {} were looked at inside the windows for hinges, of which {} meet{} "
      "all requirements.",
      grouped_text(found.inside->looked_at), grouped_text(found.inside->meeting),
      found.inside->meeting == 1 ? "s" : "");
}

bool nothing_meets_requirements(const Findings& found) {
  return found.meeting_requirements == 0 && !(found.inside && found.inside->meeting > 0);
}

namespace {

bool has_warning(const Findings& found, std::string_view code) {
  return std::any_of(found.warnings.begin(), found.warnings.end(),
                     [&](const Notice& notice) { return notice.code == code; });
}

}  // namespace

void explain_empty_list(Findings& found, bool nothing_listed) {
  if (found.options.best == 0 || !nothing_listed) return;
  const bool erased = found.left_out > 0 && found.reason.code == "searched";
  if (found.reason.code != "solved" && !erased) return;
  found.status = SolutionStatus::no_solution;
  const auto meeting = static_cast<double>(found.meeting_requirements);
  if (found.left_out > 0)
    found.reason = {"none_confirmed",
                    "What meets all requirements lies so near a change point or a dead point that round-off decides "
                    "what it does: simulation of the motion verified none. Require a minimum transmission angle.",
                    {{"count", meeting}}};
  else if (has_warning(found, "left_out_by_tolerances"))
    found.reason = {
        "none_by_samples",
        "What meets all requirements by the few samples of the solution region does not by the figures "
        "that would be listed. Optimise for the yield or the error by tolerances, or require a little less.",
        {{"count", meeting}}};
  else if (has_warning(found, "left_out_by_loads"))
    found.reason = {"none_under_loads",
                    "What meets all requirements by the stations at which the solution region looks does not by the "
                    "largest forces over the travel. Require a little less, or look at more \"stations\" of the "
                    "loads.",
                    {{"count", meeting}}};
  else if (found.options.objective == Objective::structural_error)
    found.reason = {
        "none_reaches",
        fmt::format("Of the four-bars that meet all requirements ({}) none moves its input through the whole "
                    "range of the function. Shorten the range, or move the precision points.",
                    grouped_text(found.meeting_requirements)),
        {{"count", meeting}}};
  else if (found.of_task && found.options.objective == Objective::near_error)
    found.reason = {
        "none_past_near_poses",
        fmt::format("Of the four-bars that meet all requirements ({}) none passes the near poses in their order and "
                    "past no dead point. Move or leave out near poses, or rank by another objective.",
                    grouped_text(found.meeting_requirements)),
        {{"count", meeting}}};
  else
    found.reason = {"none_beside_limits",
                    "What meets all requirements does so by round-off alone: it lies exactly at a limit. Relax "
                    "one of them a little.",
                    {{"count", meeting}}};
}

ReasonFacts reason_facts(const FourBarAnswer& answer) {
  ReasonFacts facts{answer.given.has_directions,
                    fmt::format("No pair of dyads makes a four-bar: in every pair a pivot is at infinity{} or a link "
                                "has no length.",
                                answer.dyads_left_out > 0 ? ", a dyad was discarded" : ""),
                    "", is_complete(*answer.family())};
  for (const MissedBox& missed : answer.missed_boxes) facts.missed += " " + missed_box_text(missed);
  return facts;
}

ReasonFacts reason_facts(const SphericalAnswer& answer) {
  return {answer.given.has_directions, "No pair of dyads makes a four-bar: in every pair a link has no length.", "",
          is_complete(*answer.given.family)};
}

void state_reason(Findings& answer, const TaskWords& words, const ReasonFacts& facts) {
  const RegionCounts& counts = answer.counts;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0 && !(answer.inside && answer.inside->looked_at > 0)) {
    answer.status = SolutionStatus::no_solution;
    answer.reason = {"no_pair", facts.no_pair, {}};
  } else if (nothing_meets_requirements(answer) && counts.defect_free == 0 && answer.requirements.no_defects &&
             !(answer.inside && answer.inside->is_empty)) {
    answer.reason = nothing_defect_free(answer, words, facts);
  } else if (nothing_meets_requirements(answer)) {
    answer.reason = nothing_left(answer, words, facts);
  } else {
    answer.reason = {
        "solved",
        fmt::format("All {}: {}; free of defects: {}; meeting all requirements: {}.", words.four_bars,
                    grouped_text(whole), grouped_text(counts.defect_free), grouped_text(answer.meeting_requirements)) +
            after_a_sentence(found_inside_text(answer)),
        {{"count", static_cast<double>(whole)},
         {"defect_free", static_cast<double>(counts.defect_free)},
         {"meeting", static_cast<double>(answer.meeting_requirements)}}};
  }
}

}  // namespace linkwright
