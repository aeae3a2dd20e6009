#include "searched_lines.hpp"

#include "linkwright/straight_line/straight_line_solution.hpp"

namespace linkwright {

double SearchedLines::distance(const LineCandidate& a, const LineCandidate& b) const {
  return farthest_pivot(a.linkage.bars, b.linkage.bars);
}

std::optional<StraightLineSolution> SearchedLines::make(MapPoint place) const {
  return make_straight_line(family(), place);
}

bool SearchedLines::is_confirmed(const LineCandidate& candidate, const StraightLineSolution& made) const {
  return candidate.type() == made.type && linkwright::is_confirmed(made);
}

bool is_confirmed(const StraightLineSolution& made) {
  return made.verified_by_driving && made.contact.points >= promised_contact(made.task.given);
}

}  // namespace linkwright
