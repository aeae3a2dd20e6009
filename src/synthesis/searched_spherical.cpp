#include "searched_spherical.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

double between_lines(Vector3 a, Vector3 b) { return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))); }

double farthest_axis(const SphericalFourBar& a, const SphericalFourBar& b) {
  return std::max({between_lines(a.input_fixed, b.input_fixed), between_lines(a.input_moving, b.input_moving),
                   between_lines(a.output_fixed, b.output_fixed), between_lines(a.output_moving, b.output_moving)});
}

}  // namespace

double SearchedSphericalFourBars::distance(const SphericalCandidate& a, const SphericalCandidate& b) const {
  return std::min(farthest_axis(a.bars, b.bars), farthest_axis(a.bars, b.bars.swapped()));
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
