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
struct Offer {
  double best_score = -std::numeric_limits<double>::infinity();
  std::int64_t meeting = 0, defect_free = 0, whole = 0;

  [[nodiscard]] bool beats(const Offer& other) const {
    return std::tie(best_score, meeting, defect_free, whole) >
           std::tie(other.best_score, other.meeting, other.defect_free, other.whole);
  }
};

Offer offer_of(const FourBarFamily& family, const Requirements& requirements, Objective objective, RegionMap& map) {
  const std::vector<double> input = family.samples(Side::input, ChosenLength::samples, Spacing::coordinate),
                            output = family.samples(Side::output, ChosenLength::samples, Spacing::coordinate);
  if (input.empty() || output.empty()) return {};
  family.classify(map, input, output, requirements.respect_direction);
  const RequirementFilter filter = filter_of(family, map, requirements);
  const RegionCounts counts = map.counts();
  Offer offer;
  offer.meeting = filter.census().meeting;
  offer.defect_free = counts.defect_free;
  offer.whole = counts.pairs - counts.types[static_cast<std::size_t>(LinkageType::degenerate)];
  if (const auto best = tile_bests(map, filter, objective, 1); !best.empty()) offer.best_score = best.front().score;
  return offer;
}

}  // namespace

ChosenLength chosen_length(const FamilyOfLength& family_of, const WorkingFrame& frame, const Requirements& requirements,
                           Objective objective) {
  require(requirements.max_length.has_value(), "max_length is set");
  ChosenLength chosen;
  Offer best;
  RegionMap map;
  // A side link longer than the longest link allowed is of no use: with small turns L is far larger than the machine.
  const double longest = std::min(ChosenLength::longest * frame.scale, *requirements.max_length);
  for (int rung = 0; rung < ChosenLength::rungs; ++rung) {
    const double share = 1 - static_cast<double>(rung) / (ChosenLength::rungs - 1);
    const double length = longest * std::pow(ChosenLength::range, -share);
    const Offer offer = offer_of(*family_of(length), requirements, objective, map);
    if (rung > 0 && !offer.beats(best)) continue;
    best = offer;
    chosen = {length, offer.meeting};
  }
  return chosen;
}

}  // namespace linkwright
