#include "searched_four_bars.hpp"

namespace linkwright {

std::optional<FourBarSolution> SearchedFourBars::make(MapPoint place) const {
  constexpr bool verify = true;
  return make_four_bar(answer_.given, place, answer_.requirements.respect_direction, verify);
}

bool SearchedFourBars::is_confirmed(const Candidate& candidate, const FourBarSolution& made) const {
  const DefectReport &here = candidate.report, &there = made.report;
  return here.type == there.type && here.defects == there.defects && !is_unconfirmed(made);
}

}  // namespace linkwright
