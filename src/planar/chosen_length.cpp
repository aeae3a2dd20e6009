#include "linkwright/planar/chosen_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

// How much a map has to offer; the larger is the better one.
struct MapSummary {
  double best_score = -std::numeric_limits<double>::infinity();
  std::int64_t meeting = 0, defect_free = 0, whole = 0;

  [[nodiscard]] bool beats(const MapSummary& other) const {
    return std::tie(best_score, meeting, defect_free, whole) >
           std::tie(other.best_score, other.meeting, other.defect_free, other.whole);
  }
};

MapSummary summary_of(const FourBarFamily& family, const Requirements& requirements, Objective objective,
                      RegionMap& map) {
  const std::vector<double> input = family.samples(Side::input, ChosenLength::samples, Spacing::coordinate),
                            output = family.samples(Side::output, ChosenLength::samples, Spacing::coordinate);
  if (input.empty() || output.empty()) return {};
  family.classify(map, input, output, requirements.respect_direction);
  const RequirementFilter filter = filter_of(family, map, requirements);
  const RegionCounts counts = map.counts();
  MapSummary summary;
  summary.meeting = filter.census().meeting;
  summary.defect_free = counts.defect_free;
  summary.whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  // Tolerances are measured of one map, that of the length chosen.
  const Objective ranked = is_of_tolerances(objective) ? Objective::min_transmission_angle : objective;
  if (const auto best = tile_bests(map, filter, ranked, 1); !best.empty()) summary.best_score = best.front().score;
  return summary;
}

}  // namespace

ChosenLength chosen_length(const FamilyOfLength& family_of, const WorkingFrame& frame, const Requirements& requirements,
                           Objective objective) {
  require(requirements.max_length.has_value(), "max_length is set");
  ChosenLength chosen;
  MapSummary best;
  RegionMap map;
  // A grounded link longer than the longest link allowed is of no use: with small turns L is far larger than the
  // machine.
  const double longest = std::min(ChosenLength::longest * frame.scale, *requirements.max_length);
  for (int trial = 0; trial < ChosenLength::trials; ++trial) {
    const double share = 1 - static_cast<double>(trial) / (ChosenLength::trials - 1);
    const double length = longest * std::pow(ChosenLength::range, -share);
    const MapSummary summary = summary_of(*family_of(length), requirements, objective, map);
    if (trial > 0 && !summary.beats(best)) continue;
    best = summary;
    chosen = {length, summary.meeting};
  }
  return chosen;
}

}  // namespace linkwright
