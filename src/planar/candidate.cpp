#include "planar/candidate.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

bool is_locked(const DefectReport& report) { return report.min_transmission_angle < tolerance::dead_at_position; }

}  // namespace

std::optional<Candidate> CellEvaluator::candidate(MapPoint place) const {
  const auto links = family_.dyad_pair(place);
  return links ? evaluated(place, *links) : std::nullopt;
}

std::optional<Candidate> CellEvaluator::candidate(MapPoint place, const Candidate& known) const {
  const auto links = family_.dyad_pair_reusing(place, known.links);
  return links ? evaluated(place, *links) : std::nullopt;
}

std::optional<Candidate> CellEvaluator::evaluated(MapPoint place, const DyadPair& links) const {
  const Requirements& wanted = requirements_;
  const auto four_bar = four_bar_of(links);
  if (!four_bar || !is_within(family_, window_, place)) return std::nullopt;
  const FourBar& bars = *four_bar;
  const DefectReport report = find_defects(bars, family_.working_poses(place, bars), wanted.respect_direction);
  if (report.type == LinkageType::degenerate) return std::nullopt;
  const auto& types = wanted.types;
  if (!types.empty() && std::find(types.begin(), types.end(), report.type) == types.end()) return std::nullopt;
  if (wanted.no_defects && (!report.defects.none() || is_locked(report))) return std::nullopt;
  if (report.min_transmission_angle < wanted.min_transmission_angle) return std::nullopt;
  const LinkLengths lengths = bars.lengths();
  const double ratio = lengths.longest() / lengths.shortest();
  const double longest = family_.frame().scale * lengths.longest();
  if (ratio > wanted.max_link_ratio || longest > wanted.max_length.value_or(Requirements::unlimited))
    return std::nullopt;
  if (family_.frame().scale * lengths.shortest() < wanted.min_length.value_or(0)) return std::nullopt;
  if (!inside(wanted.ground_pivots_within, bars.input_center, bars.output_center)) return std::nullopt;
  if (!inside(wanted.moving_pivots_within, bars.input_circle, bars.output_circle)) return std::nullopt;
  const double own = score_of(objective_, {versine_of_angle(report.min_transmission_angle), ratio, longest});
  const auto score = added_.score(place, wanted, objective_, own);
  return score ? std::optional(Candidate{place, links, bars, report, *score, false}) : std::nullopt;
}

bool CellEvaluator::inside(const std::optional<Box>& box, Point p, Point q) const {
  return !box || (box->contains(family_.frame().to_user(p)) && box->contains(family_.frame().to_user(q)));
}

double CellEvaluator::change_point_margin(const Candidate& here) const {
  const GrashofExcesses t = grashof_excesses(here.bars.lengths());
  return std::min({std::abs(t.t1), std::abs(t.t2), std::abs(t.t3)}) / here.bars.lengths().perimeter();
}

Candidate CellEvaluator::from_better_side(const Candidate& here) const {
  if (!family_.is_symmetric()) return here;
  auto there = evaluated({here.place.output, here.place.input}, {here.links.output, here.links.input});
  if (!there) return here;
  there->local_optimum = here.local_optimum;
  return better_driver(here, *there);
}

}  // namespace linkwright
