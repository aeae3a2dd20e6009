#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "analyses/listed_again.hpp"
#include "loads_analysis.hpp"
#include "synthesis/listed_linkages.hpp"

namespace linkwright {
namespace {

std::optional<double> listed(const std::optional<LoadReport>& report, const Measure& measure) {
  const auto read_out = read_out_of(measure);
  if (!report || !read_out) return std::nullopt;
  if (*read_out == ReadOut::best_f1) return report->best_f1;
  if (static_cast<std::size_t>(*read_out) >= read_outs) return std::nullopt;
  const auto& worst = report->worst_of(*read_out);
  return worst ? std::optional(worst->value) : std::nullopt;
}

ListedMeasures listed_measures(const Findings& found) {
  return {[](const Measure& measure) { return read_out_of(measure).has_value(); },
          [&found](std::size_t linkage, const Measure& measure) { return listed(found.loads[linkage], measure); }};
}

void warn_of_left_out(Findings& found, std::size_t count) {
  found.warnings.push_back(
      {"left_out_by_loads",
       fmt::format("{} of the best {} discarded: by the stations at which the solution region looks {} what is "
                   "required under loads, but not by the largest forces over the travel.",
                   count, count == 1 ? "was" : "were", count == 1 ? "it meets" : "they meet"),
       {{"count", static_cast<double>(count)}}});
}

/// Linkages of which a gas spring is too short or too long between positions.
void warn_of_strokes(Findings& found) {
  std::size_t count = 0;
  std::string name;
  for (const auto& report : found.loads) {
    if (!report) continue;
    for (const SpringUse& use : report->cases.front().springs)
      if (use.bottoms_at) {
        name = use.name;
        ++count;
        break;
      }
  }
  if (count == 0) return;
  found.warnings.push_back({"spring_stroke",
                            fmt::format("In {} of the linkages listed a spring ({}) leaves its stroke between two "
                                        "positions: see \"bottoms_at\".",
                                        count, name),
                            {{"count", static_cast<double>(count)}, {"name", name}}});
}

void warn_of_locking(Findings& found) {
  std::size_t count = 0;
  for (const auto& report : found.loads)
    if (report && std::any_of(report->cases.begin(), report->cases.end(), [](const auto& of) { return of.locks; }))
      ++count;
  if (count > 0)
    found.warnings.push_back({"locks_by_friction",
                              fmt::format("{} of the linkages listed cannot be moved somewhere on the way: friction "
                                          "holds them, or hand or drive act across it.",
                                          count),
                              {{"count", static_cast<double>(count)}}});
}

}  // namespace

std::optional<Requirements> report_loads(Answer& answer, const Progress& progress) {
  Findings& found = findings(answer);
  const Loads& loads = *found.options.loads;
  for (const auto& output : listed_outputs(answer, 0)) {
    const auto* planar = output ? std::get_if<PlanarOutput>(&*output) : nullptr;
    found.loads.push_back(planar && !progress.is_cancelled()
                              ? load_report(loads, planar->positions.front().bars, poses_of(*planar))
                              : std::nullopt);
  }
  const ListedMeasures by = listed_measures(found);
  LeftOut left_out;
  if (!found.options.at && !progress.is_cancelled()) left_out = leave_out_what_fails(answer, by);
  if (left_out.count > 0) warn_of_left_out(found, left_out.count);
  loads_of_list(answer);
  return std::move(left_out.with_room);
}

void loads_of_list(Answer& answer) {
  Findings& found = findings(answer);
  std::erase_if(found.warnings, [](const Notice& warning) {
    return warning.code == "spring_stroke" || warning.code == "locks_by_friction";
  });
  warn_of_strokes(found);
  warn_of_locking(found);
  rank_again(answer, listed_measures(found), [&](std::size_t i) {
    const Measure& measure = measure_of(found.options.objective);
    const auto value = listed(found.loads[i], measure);
    if (!value) return -std::numeric_limits<double>::infinity();
    return measure.larger_is_better ? *value : -*value;
  });
}

}  // namespace linkwright
