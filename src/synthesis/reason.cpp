#include "reason.hpp"

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

Notice nothing_defect_free(const Findings& answer, const TaskWords& words, bool has_directions) {
  const RegionCounts& counts = answer.counts;
  const bool directed = answer.requirements.respect_direction && has_directions;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  std::vector<std::string> causes;
  const auto blame = [&](std::int64_t cells, std::string_view what) {
    if (cells > 0) causes.push_back(fmt::format("{} {}", percent(cells, whole), what));
  };
  blame(counts.circuit, "cannot be reached without reassembly (circuit)");
  blame(counts.branch - counts.circuit, words.lock);
  blame(counts.order, directed ? "reach them in another order, or against a direction" : "reach them in another order");
  return {"none_defect_free",
          fmt::format("None of the {} ({}) is free of defects: {}. ", words.four_bars, grouped_text(whole),
                      fmt::join(causes, ", ")) +
              fmt::format(fmt::runtime(words.ways_out),
                          directed ? "turn a direction round or let none count (respect_direction: false), " : ""),
          {{"count", static_cast<double>(whole)}}};
}

Notice nothing_left(const Findings& answer, const std::string& missed) {
  const std::int64_t free = answer.counts.defect_free;
  Notice notice{"none_left",
                fmt::format("None of the four-bars free of defects ({}) meets all requirements.", grouped_text(free)),
                {{"count", static_cast<double>(free)}}};
  notice.message += missed;
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
  else if (found.options.objective == Objective::structural_error)
    found.reason = {
        "none_reaches",
        fmt::format("Of the four-bars that meet all requirements ({}) none moves its input through the whole "
                    "range of the function. Shorten the range, or move the precision points.",
                    grouped_text(found.meeting_requirements)),
        {{"count", meeting}}};
  else
    found.reason = {"none_left",
                    "What meets all requirements does so by round-off alone: it lies exactly at a limit. Relax "
                    "one of them a little.",
                    {{"count", meeting}}};
}

ReasonFacts reason_facts(const FourBarAnswer& answer) {
  ReasonFacts facts{answer.given.has_directions,
                    fmt::format("No pair of dyads makes a four-bar: in every pair a pivot is at infinity{} or a link "
                                "has no length.",
                                answer.dyads_left_out > 0 ? ", a dyad was discarded" : ""),
                    ""};
  for (const MissedBox& missed : answer.missed_boxes) facts.missed += " " + missed_box_text(missed);
  return facts;
}

void state_reason(Findings& answer, const TaskWords& words, const ReasonFacts& facts) {
  const RegionCounts& counts = answer.counts;
  const std::int64_t whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (whole == 0) {
    answer.status = SolutionStatus::no_solution;
    answer.reason = {"no_pair", facts.no_pair, {}};
  } else if (counts.defect_free == 0 && answer.requirements.no_defects) {
    answer.reason = nothing_defect_free(answer, words, facts.has_directions);
  } else if (answer.meeting_requirements == 0) {
    answer.reason = nothing_left(answer, facts.missed);
  } else {
    answer.reason = {
        "solved",
        fmt::format("All {}: {}; free of defects: {}; meeting all requirements: {}.", words.four_bars,
                    grouped_text(whole), grouped_text(counts.defect_free), grouped_text(answer.meeting_requirements)),
        {{"count", static_cast<double>(whole)},
         {"defect_free", static_cast<double>(counts.defect_free)},
         {"meeting", static_cast<double>(answer.meeting_requirements)}}};
  }
}

}  // namespace linkwright
