#pragma once

#include <optional>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/spherical/spherical_family.hpp"
#include "region/climb.hpp"

namespace linkwright {

/// A spherical four-bar that meets the requirements.
struct SphericalCandidate {
  MapPoint place;
  SphericalDyadPair links;
  SphericalFourBar bars;
  DefectReport report;
  double score = 0;  ///< as score_of
  bool local_optimum = false;

  [[nodiscard]] LinkageType type() const { return report.type; }
};

/// Judges any place of a map by the same rules as its cells. Refers to the family, which must outlive it.
class SphericalEvaluator {
 public:
  using Candidate = SphericalCandidate;

  /// `requirements` with defaults filled in. Places outside `window` are refused; nothing: none.
  SphericalEvaluator(const SphericalFamily& family, const Requirements& requirements, Objective objective,
                     std::optional<MapWindow> window = {}, AddedMeasures added = {})
      : family_(family),
        requirements_(requirements),
        objective_(objective),
        window_(window),
        added_(std::move(added)) {}

  [[nodiscard]] const SphericalFamily& family() const { return family_; }
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place) const;
  /// The same; of dyads known already those serve again whose coordinates are the place's.
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place, const Candidate& known) const;
  /// The smallest excess, as a share of the four links together.
  [[nodiscard]] double change_point_margin(const Candidate& here) const;
  /// The same bars driven from the better side that meets the requirements: no defects, score, transmission angle,
  /// smaller coordinate; as they are where the family names the input.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const;

 private:
  [[nodiscard]] std::optional<Candidate> evaluated(MapPoint place, const SphericalDyadPair& links) const;
  [[nodiscard]] bool meets(const DefectReport& report) const;
  [[nodiscard]] bool meets(const SphericalDyadPair& links) const;

  const SphericalFamily& family_;
  Requirements requirements_;
  Objective objective_;
  std::optional<MapWindow> window_;
  AddedMeasures added_;
};

}  // namespace linkwright
