#include "searched_spherical.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

// 1 − |cos| of the largest angle between two axes, which have no sense.
double farthest_axis(const SphericalFourBar& a, const SphericalFourBar& b) {
  const auto apart = [](Vector3 one, Vector3 other) { return 1 - std::abs(dot(one, other)); };
  return std::max({apart(a.input_fixed, b.input_fixed), apart(a.input_moving, b.input_moving),
                   apart(a.output_fixed, b.output_fixed), apart(a.output_moving, b.output_moving)});
}

}  // namespace

double SearchedSphericalFourBars::distance(const SphericalCandidate& a, const SphericalCandidate& b) const {
  return std::sqrt(std::max(0.0, 2 * std::min(farthest_axis(a.bars, b.bars), farthest_axis(a.bars, b.bars.swapped()))));
}

std::optional<SphericalSolution> SearchedSphericalFourBars::make(MapPoint place) const {
  constexpr bool verify = true;
  return make_spherical_four_bar(answer_.given, place, answer_.requirements.respect_direction, verify);
}

bool SearchedSphericalFourBars::is_confirmed(const SphericalCandidate& candidate, const SphericalSolution& made) const {
  const DefectReport &here = candidate.report, &there = made.report;
  return here.type == there.type && here.defects == there.defects && !is_unconfirmed(made);
}

}  // namespace linkwright
