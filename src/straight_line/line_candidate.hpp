#pragma once

#include <optional>

#include "linkwright/region/added_measures.hpp"
#include "linkwright/straight_line/line_worth.hpp"
#include "linkwright/straight_line/straight_line_family.hpp"
#include "region/climb.hpp"
#include "straight_line/line_estimate.hpp"

namespace linkwright {

/// A linkage of a map of straight lines that meets the requirements, measured exactly.
struct LineCandidate {
  MapPoint place;
  TracingFourBar linkage;
  double score = 0;   ///< as score_of
  double usable = 0;  ///< length that counts
  bool local_optimum = false;

  [[nodiscard]] LinkageType type() const { return linkage_type(linkage.bars.lengths()); }
};

/// Judges any place of a map by the same rules as its cells. Refers to the family, which must outlive it.
class LineEvaluator {
 public:
  using Candidate = LineCandidate;

  /// `requirements` with defaults filled in.
  LineEvaluator(const StraightLineFamily& family, const Requirements& requirements, Objective objective,
                AddedMeasures added = {})
      : family_(family),
        line_(estimate_task(family)),
        requirements_(requirements),
        objective_(objective),
        added_(std::move(added)) {}

  [[nodiscard]] const StraightLineFamily& family() const { return family_; }
  [[nodiscard]] const Requirements& requirements() const { return requirements_; }
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place) const;
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place, const Candidate& /*known*/) const {
    return candidate(place);
  }
  /// The smallest excess, as a share of the perimeter.
  [[nodiscard]] double change_point_margin(const Candidate& here) const;
  /// The family names the input.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const { return here; }

 private:
  const StraightLineFamily& family_;
  LineEstimateTask line_;
  Requirements requirements_;
  Objective objective_;
  AddedMeasures added_;
};

}  // namespace linkwright
