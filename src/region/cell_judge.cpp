#include "linkwright/region/cell_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::optional<std::size_t> place_of(const Measure* measure, std::span<const Measure> measures) {
  const auto found = measure ? std::find(measures.begin(), measures.end(), *measure) : measures.end();
  return found == measures.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - measures.begin()));
}

bool is_one_of(const std::vector<LinkageType>& types, LinkageType type) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

bool CellJudge::Place::holds(const Pivots& pivots) const {
  const Hinges& hinges = pivots.*of_linkage;
  return std::all_of(hinges.begin(), hinges.end(), [&](Vector3 hinge) { return contains(within, hinge); });
}

CellJudge::CellJudge(const Requirements& wanted, const LinkageClass& linkages, std::span<const Measure> measures)
    : kinds_(linkages.requirements) {
  for (std::size_t k = 0; k < kinds_.size(); ++k)
    add(criterion(kinds_[k]), static_cast<FailureBits>(1u << k), wanted, measures);
  of_type_[static_cast<std::size_t>(LinkageType::degenerate)] = all_failures;
}

void CellJudge::add_types(FailureBits bit, const std::function<bool(LinkageType)>& passes) {
  for (std::size_t type = 0; type < of_type_.size(); ++type)
    if (!passes(static_cast<LinkageType>(type))) of_type_[type] |= bit;
}

void CellJudge::add(const Criterion& asked, FailureBits bit, const Requirements& wanted,
                    std::span<const Measure> measures) {
  using Rule = Criterion::Rule;
  switch (asked.rule) {
    case Rule::one_of_types:
      if (!wanted.types.empty()) add_types(bit, [&](LinkageType type) { return is_one_of(wanted.types, type); });
      return;
    case Rule::without_defects:
      of_defects_ = wanted.no_defects ? bit : FailureBits{0};
      if (wanted.no_defects) transmission_ = place_of(&measures::min_transmission_angle, measures);
      return;
    case Rule::turning_fully:
      if (wanted.full_turn) add_types(bit, input_is_crank);
      return;
    case Rule::at_least:
    case Rule::at_most:
      return add_bound(asked, bit, asked.limit(wanted), measures);
    case Rule::ground_inside:
      if (const auto within = asked.window(wanted))
        places_.push_back({asked.kind, bit, &GroundedLinkPivots::ground, &Pivots::ground, *within});
      return;
    case Rule::moving_inside:
      if (const auto within = asked.window(wanted))
        places_.push_back({asked.kind, bit, &GroundedLinkPivots::moving, &Pivots::moving, *within});
      return;
  }
}

void CellJudge::add_bound(const Criterion& asked, FailureBits bit, double limit, std::span<const Measure> measures) {
  constexpr double finite = std::numeric_limits<float>::max();
  const auto of = place_of(asked.of, measures);
  if (!of) return;
  const double most = asked.lets_infinite_pass ? limit : std::min(limit, finite);
  const double stored = asked.of->stored == Measure::Stored::as_versine ? versine_of_angle(most) : most;
  bounds_.push_back({&asked, bit, *of, place_of(asked.per, measures), stored});
}

FailureBits CellJudge::failures(LinkageType type, Defects defects) const {
  const unsigned of_type = of_type_[static_cast<std::size_t>(type)];
  return static_cast<FailureBits>(of_type | (defects.none() ? 0u : of_defects_));
}

FailureBits CellJudge::failures(const Cell& cell, bool unknown_passes) const {
  static const double dead = versine_of_angle(tolerance::dead_at_position);
  unsigned failed = failures(cell.type, cell.defects);
  if (transmission_ && cell.values[*transmission_] < dead) failed |= of_defects_;
  for (const Bound& bound : bounds_) {
    const double limit = bound.per ? bound.limit * cell.values[*bound.per] : bound.limit;
    const double value = cell.values[bound.of];
    const bool is_met = bound.is_least() ? value >= limit : value <= limit;
    const bool is_unknown = std::isnan(value) || std::isnan(limit);
    if (!is_met && !(is_unknown && unknown_passes)) failed |= bound.bit;
  }
  for (const Place& place : places_)
    if (!place.holds(cell.pivots)) failed |= place.bit;
  return static_cast<FailureBits>(failed);
}

}  // namespace linkwright
