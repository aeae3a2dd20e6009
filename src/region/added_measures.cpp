#include "linkwright/region/added_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {
namespace {

/// A measure of the cells that meet requirements; of others it is not worth its time.
class AmongPassing : public CellMeasure {
 public:
  /// Refers to both.
  AmongPassing(const CellMeasure& of, const RequirementFilter& filter)
      : CellMeasure(of.measure()), of_(of), filter_(filter) {}

  [[nodiscard]] std::optional<double> at(MapPoint place) const override { return of_.at(place); }
  [[nodiscard]] Rows rows_of(const RegionMap& map) const override {
    return [this, &map](std::size_t row, std::span<float> values) {
      for (std::size_t column = 0; column < values.size(); ++column) {
        const MapPoint place = {map.input_coordinates()[row], map.output_coordinates()[column]};
        const auto found = filter_.passes(row, column) ? at(place) : std::nullopt;
        values[column] = found ? static_cast<float>(*found) : std::numeric_limits<float>::quiet_NaN();
      }
    };
  }

 private:
  const CellMeasure& of_;
  const RequirementFilter& filter_;
};

bool is_on(const Criterion& criterion, const AddedMeasure& added) {
  return criterion.of && *criterion.of == added.measure->measure();
}

}  // namespace

const AddedMeasure* AddedMeasures::find(const Measure& measure) const {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& added) { return added.measure->measure() == measure; });
  return found == all.end() ? nullptr : &*found;
}

const AddedMeasure* AddedMeasures::sampled() const {
  const auto found =
      std::find_if(all.begin(), all.end(), [](const auto& added) { return added.cost == AddedMeasure::Cost::sampled; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<const Criterion*> AddedMeasures::criteria_on(const AddedMeasure& added) {
  std::vector<const Criterion*> found;
  for (const Criterion& criterion : criteria())
    if (is_on(criterion, added)) found.push_back(&criterion);
  return found;
}

bool AddedMeasures::is_required(const AddedMeasure& added, const Requirements& wanted) {
  return std::any_of(criteria().begin(), criteria().end(),
                     [&](const Criterion& asked) { return is_on(asked, added) && asked.has_limit(wanted); });
}

bool AddedMeasures::is_asked(const AddedMeasure& added, const Requirements& wanted, Objective objective) {
  return measure_of(objective) == added.measure->measure() || is_required(added, wanted);
}

bool AddedMeasures::are_required(const Requirements& wanted) const {
  return std::any_of(all.begin(), all.end(), [&](const AddedMeasure& added) {
    return added.cost != AddedMeasure::Cost::sampled && is_required(added, wanted);
  });
}

Requirements AddedMeasures::all_else(const AddedMeasure& added, const Requirements& wanted) const {
  Requirements left = wanted;
  for (const AddedMeasure* later = &added; later != all.data() + all.size(); ++later)
    for (const Criterion& criterion : criteria())
      if (is_on(criterion, *later)) criterion.set(left, criterion.any);
  return left;
}

std::vector<Measure> AddedMeasures::filled_by(const CellMeasures& together) const {
  std::vector<Measure> measures;
  for (const AddedMeasure& added : all)
    if (added.together.get() == &together) measures.push_back(added.measure->measure());
  return measures;
}

void AddedMeasures::add_to(RegionMap& map, const LinkageFamily& family, const Requirements& wanted, bool with_sampled,
                           const Progress& progress) const {
  std::vector<const CellMeasures*> filled;
  for (const AddedMeasure& added : all) {
    if (const CellMeasures* together = added.together.get()) {
      if (std::find(filled.begin(), filled.end(), together) != filled.end()) continue;
      filled.push_back(together);
      const std::vector<Measure> measures = filled_by(*together);
      map.add(measures, together->rows_of(map, measures), progress);
    } else if (added.cost == AddedMeasure::Cost::light)
      map.add(*added.measure, progress);
    else if (added.cost == AddedMeasure::Cost::heavy || with_sampled)
      map.add(AmongPassing(*added.measure, filter_of(family, map, all_else(added, wanted))), progress);
  }
}

std::vector<RequirementKind> AddedMeasures::failures_at(MapPoint place, const Requirements& wanted) const {
  std::vector<RequirementKind> failed;
  for (const AddedMeasure& added : all)
    for (const Criterion& asked : criteria()) {
      if (!is_on(asked, added) || !asked.has_limit(wanted)) continue;
      const auto measured = added.measure->at(place);
      if (!measured || !asked.is_met_by(*measured, asked.limit(wanted))) failed.push_back(asked.kind);
    }
  return failed;
}

std::optional<double> AddedMeasures::passing(const AddedMeasure& added, MapPoint place, const Requirements& wanted) {
  const auto measured = added.measure->at(place);
  if (!measured || !std::isfinite(*measured)) return std::nullopt;
  for (const Criterion& asked : criteria())
    if (is_on(asked, added) && asked.has_limit(wanted) &&
        !asked.is_met_by(*measured, asked.stricter(asked.limit(wanted), added.margin)))
      return std::nullopt;
  return measured;
}

std::optional<double> AddedMeasures::score(MapPoint place, const Requirements& wanted, Objective objective,
                                           double own) const {
  constexpr double tie = 1e-9;  // less than one sample of the largest number of them
  const AddedMeasure* by = find(measure_of(objective));
  const AddedMeasure* tied = by && by->tie ? find(*by->tie) : nullptr;
  double score = own, second = 0;
  for (const AddedMeasure& added : all) {
    if (&added != tied && !is_asked(added, wanted, objective)) continue;
    const auto measured = passing(added, place, wanted);
    if (!measured) return std::nullopt;
    const double larger_better = added.measure->measure().larger_is_better ? *measured : -*measured;
    if (&added == by) score = larger_better;
    if (&added == tied) second = larger_better;
  }
  return tied ? score + tie * second / (1 + std::abs(second)) : score;
}

}  // namespace linkwright
