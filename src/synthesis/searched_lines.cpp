#include "searched_lines.hpp"

#include "linkwright/straight_line/straight_line_solution.hpp"

namespace linkwright {

double SearchedLines::distance(const LineCandidate& a, const LineCandidate& b) const {
  return farthest_pivot(a.linkage.bars, b.linkage.bars);
}

std::optional<StraightLineSolution> SearchedLines::make(MapPoint place) const {
  constexpr double borne_out = 0.97;  // of what a strip was estimated to be: a climb finds where estimates are wrong
  auto found = make_straight_line(family(), place);
  if (!found || family().measuring().measure != LineMeasure::strip) return found;
  const auto climbed = candidate(place);
  const bool is_borne_out = climbed && found->usable_strip.length() >= borne_out * climbed->usable;
  return is_borne_out && failures_of(*found, requirements()).empty() ? found : std::nullopt;
}

bool SearchedLines::is_confirmed(const LineCandidate& candidate, const StraightLineSolution& made) const {
  return candidate.type() == made.type && linkwright::is_confirmed(made);
}

bool is_confirmed(const StraightLineSolution& made) {
  return made.verified_by_driving && made.contact.points >= promised_contact(made.task.given);
}

}  // namespace linkwright
