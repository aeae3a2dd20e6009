#include "spherical/spherical_candidate.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/spherical/spherical_defects.hpp"
#include "linkwright/spherical/spherical_type.hpp"
#include "spherical/spherical_triangle.hpp"

namespace linkwright {

std::optional<SphericalCandidate> SphericalEvaluator::candidate(MapPoint place) const {
  const auto links = family_.dyad_pair(place);
  return links ? evaluated(place, *links) : std::nullopt;
}

std::optional<SphericalCandidate> SphericalEvaluator::candidate(MapPoint place, const Candidate& known) const {
  const auto links = family_.dyad_pair_reusing(place, known.links);
  return links ? evaluated(place, *links) : std::nullopt;
}

bool SphericalEvaluator::meets(const DefectReport& report) const {
  const Requirements& wanted = requirements_;
  const auto& types = wanted.types;
  if (report.type == LinkageType::degenerate) return false;
  if (!types.empty() && std::find(types.begin(), types.end(), report.type) == types.end()) return false;
  const bool is_locked = report.min_transmission_angle < tolerance::dead_at_position;
  if (wanted.no_defects && (!report.defects.none() || is_locked)) return false;
  return report.min_transmission_angle >= wanted.min_transmission_angle;
}

bool SphericalEvaluator::meets(const SphericalDyadPair& links) const {
  const auto inside = [](const std::optional<Cone>& cone, Vector3 one, Vector3 other) {
    return !cone || (cone->contains(one) && cone->contains(other));
  };
  return inside(requirements_.fixed_axes_within, links.input.fixed_axis, links.output.fixed_axis) &&
         inside(requirements_.moving_axes_within, links.input.moving_axis, links.output.moving_axis);
}

std::optional<SphericalCandidate> SphericalEvaluator::evaluated(MapPoint place, const SphericalDyadPair& links) const {
  if (!is_within(family_, window_, place) || !meets(links)) return std::nullopt;
  const SphericalFourBar bars = family_.four_bar(links);
  const DefectReport report = find_defects(bars, family_.orientations(place, bars), requirements_.respect_direction);
  if (!meets(report)) return std::nullopt;
  double least = pi, largest = 0;
  for (const double arc : bars.angles().all()) {
    least = std::min(least, acute_angle(arc));
    largest = std::max(largest, acute_angle(arc));
  }
  if (least < requirements_.min_link_angle.value_or(0) || largest > requirements_.max_link_angle.value_or(pi))
    return std::nullopt;
  RankedNumbers numbers;
  numbers.transmission_versine = versine_of_angle(report.min_transmission_angle);
  numbers.link_versine = versine_of_angle(least);
  const auto score = added_.score(place, requirements_, objective_, score_of(objective_, numbers));
  return score ? std::optional(SphericalCandidate{place, links, bars, report, *score, false}) : std::nullopt;
}

double SphericalEvaluator::change_point_margin(const SphericalCandidate& here) const {
  const LinkAngles l = here.bars.angles();
  const SphericalExcesses t = spherical_excesses(l);
  double together = 0;
  for (const double arc : l.all()) together += acute_angle(arc);
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3), std::abs(t.t4)}) / together;
}

SphericalCandidate SphericalEvaluator::from_better_side(const SphericalCandidate& here) const {
  if (!family_.is_symmetric()) return here;
  auto there = evaluated({here.place.output, here.place.input}, {here.links.output, here.links.input});
  if (!there) return here;
  there->local_optimum = here.local_optimum;
  return better_driver(here, *there);
}

}  // namespace linkwright
