#include "searched_four_bars.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

double farthest_pivot(const FourBar& a, const FourBar& b) {
  return std::max({std::abs(a.input_center - b.input_center), std::abs(a.input_circle - b.input_circle),
                   std::abs(a.output_center - b.output_center), std::abs(a.output_circle - b.output_circle)});
}

}  // namespace

double SearchedFourBars::distance(const Candidate& a, const Candidate& b) const {
  return std::min(farthest_pivot(a.bars, b.bars), farthest_pivot(a.bars, b.bars.swapped()));
}

std::optional<FourBarSolution> SearchedFourBars::make(MapPoint place) const {
  constexpr bool verify = true;
  return make_four_bar(answer_.given, place, answer_.requirements.respect_direction, verify);
}

bool SearchedFourBars::is_confirmed(const Candidate& candidate, const FourBarSolution& made) const {
  const DefectReport &here = candidate.report, &there = made.report;
  return here.type == there.type && here.defects == there.defects && !is_unconfirmed(made);
}

}  // namespace linkwright
