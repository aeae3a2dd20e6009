#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/region/cell_measure.hpp"
#include "linkwright/region/criterion.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

class LinkageFamily;

/// What is asked of a family's linkages beside what it measures itself: how they bear errors of their dimensions. Null:
/// not asked.
struct AddedMeasures {
  std::shared_ptr<const CellMeasure> tolerance_error, yield;
  /// By how much a yield by few samples has to be above what is required, so that it is met by many, too.
  double yield_margin = 0;
  bool of_passing = false;  ///< errors take so long that only cells that meet all else are worth it

  /// Columns of a map of the family: errors, and `yields` of the cells that meet all else; NaN where a cell is passed
  /// over. Throws std::bad_alloc.
  void add_to(RegionMap& map, const LinkageFamily& family, const Requirements& wanted, bool yields,
              const Progress& progress = {}) const;

  /// The requirements on them that the linkage at a place fails.
  [[nodiscard]] std::vector<RequirementKind> failures_at(MapPoint place, const Requirements& wanted) const;

  /// What a place scores, larger being better: by these where the objective is one of them, otherwise `own`. Of two
  /// linkages of the same yield the one with the smaller error is better. Nothing where a requirement on them fails.
  [[nodiscard]] std::optional<double> score(MapPoint place, const Requirements& wanted, Objective objective,
                                            double own) const;
};

}  // namespace linkwright
