#include "searched_four_bars.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {

double farthest_pivot(const FourBar& a, const FourBar& b) {
  const auto farthest = [](const FourBar& one, const FourBar& other) {
    return std::max({std::abs(one.input_center - other.input_center), std::abs(one.input_circle - other.input_circle),
                     std::abs(one.output_center - other.output_center),
                     std::abs(one.output_circle - other.output_circle)});
  };
  return std::min(farthest(a, b), farthest(a, b.swapped()));
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
