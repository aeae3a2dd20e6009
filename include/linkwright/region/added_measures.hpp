#pragma once

#include <cstdint>
#include <functional>
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

/// A number that an analysis asks of a family's linkages, which the family itself does not measure.
struct AddedMeasure {
  enum class Cost : std::uint8_t {
    light,    ///< every cell of a map is measured
    heavy,    ///< only those that meet all else that is required
    sampled,  ///< the same, and only where the measure is asked for
  };

  std::shared_ptr<const CellMeasure> measure;
  /// Fills its column at once with those of the others that name the same; null: it fills its own. Of light ones.
  std::shared_ptr<const CellMeasures> together = {};
  Cost cost = Cost::light;
  /// By how much what a map measures is to be better than a limit, so that what is listed keeps it, too; none: by
  /// nothing.
  std::function<double(double limit)> margin_of = {};
  double margin = 0;             ///< which the search keeps
  const Measure* tie = nullptr;  ///< asked before it: of two that are equal, the one that is better by this is better
};

/// What analyses ask of a family's linkages. What comes later takes longer; one at most is sampled.
struct AddedMeasures {
  std::vector<AddedMeasure> all;

  /// Null: it is not asked.
  [[nodiscard]] const AddedMeasure* find(const Measure& measure) const;
  /// The one that is sampled; null without one.
  [[nodiscard]] const AddedMeasure* sampled() const;
  /// The requirements on one of them.
  [[nodiscard]] static std::vector<const Criterion*> criteria_on(const AddedMeasure& added);
  [[nodiscard]] static bool is_required(const AddedMeasure& added, const Requirements& wanted);
  /// The same, or the objective is by it.
  [[nodiscard]] static bool is_asked(const AddedMeasure& added, const Requirements& wanted, Objective objective);
  /// A requirement is on one that is not sampled.
  [[nodiscard]] bool are_required(const Requirements& wanted) const;
  /// Without the requirements on this one and on those that take longer.
  [[nodiscard]] Requirements all_else(const AddedMeasure& added, const Requirements& wanted) const;

  /// Columns of a map of the family, and `with_sampled` of what is sampled; NaN where a cell is passed over. Throws
  /// std::bad_alloc.
  void add_to(RegionMap& map, const LinkageFamily& family, const Requirements& wanted, bool with_sampled,
              const Progress& progress = {}) const;

  /// The requirements on them that the linkage at a place fails.
  [[nodiscard]] std::vector<RequirementKind> failures_at(MapPoint place, const Requirements& wanted) const;

  /// What a place scores, larger being better: by these where the objective is one of them, otherwise `own`. Nothing
  /// where a requirement on them fails.
  [[nodiscard]] std::optional<double> score(MapPoint place, const Requirements& wanted, Objective objective,
                                            double own) const;

 private:
  [[nodiscard]] std::vector<Measure> filled_by(const CellMeasures& together) const;
  /// What is measured at a place: finite, and with the margin what is required of it; otherwise nothing.
  [[nodiscard]] static std::optional<double> passing(const AddedMeasure& added, MapPoint place,
                                                     const Requirements& wanted);
};

}  // namespace linkwright
