#pragma once

#include <optional>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/region/added_measures.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"
#include "region/climb.hpp"

namespace linkwright {

/// A linkage that meets the requirements. Working frame.
struct Candidate {
  MapPoint place;
  DyadPair links;
  FourBar bars;
  DefectReport report;
  double score = 0;  ///< as score_of
  bool local_optimum = false;

  [[nodiscard]] LinkageType type() const { return report.type; }
};

/// Judges any place of the map by the same rules as its cells. Refers to the family, which must outlive it.
class CellEvaluator {
 public:
  using Candidate = linkwright::Candidate;

  /// `requirements` with both lengths set. Places outside `window` are refused; nothing: none.
  CellEvaluator(const FourBarFamily& family, const Requirements& requirements, Objective objective,
                std::optional<MapWindow> window = {}, AddedMeasures added = {})
      : family_(family),
        requirements_(requirements),
        objective_(objective),
        window_(window),
        added_(std::move(added)) {}

  [[nodiscard]] const FourBarFamily& family() const { return family_; }

  /// The linkage at a place, or nothing where it does not meet the requirements or lies outside the window.
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place) const;
  /// The same; of grounded links known already those serve again whose coordinates are the place's.
  [[nodiscard]] std::optional<Candidate> candidate(MapPoint place, const Candidate& known) const;

  /// The smallest excess, as a share of the perimeter.
  [[nodiscard]] double change_point_margin(const Candidate& here) const;

  /// The same bars driven from the better side that meets the requirements: no defects, score, transmission angle,
  /// smaller coordinate; as they are where the family names the input.
  [[nodiscard]] Candidate from_better_side(const Candidate& here) const;

 private:
  [[nodiscard]] std::optional<Candidate> evaluated(MapPoint place, const DyadPair& links) const;
  [[nodiscard]] bool inside(const std::optional<Box>& box, Point p, Point q) const;

  const FourBarFamily& family_;
  Requirements requirements_;
  Objective objective_;
  std::optional<MapWindow> window_;
  AddedMeasures added_;
};

}  // namespace linkwright
