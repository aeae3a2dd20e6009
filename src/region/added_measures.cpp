#include "linkwright/region/added_measures.hpp"

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

}  // namespace

void AddedMeasures::add_to(RegionMap& map, const LinkageFamily& family, const Requirements& wanted, bool yields,
                           const Progress& progress) const {
  Requirements all_else = wanted;
  all_else.min_yield = 0;
  if (tolerance_error && !of_passing) map.add(*tolerance_error, progress);
  if (tolerance_error && of_passing) {
    Requirements but_errors = all_else;
    but_errors.max_tolerance_error = Requirements::unlimited;
    map.add(AmongPassing(*tolerance_error, filter_of(family, map, but_errors)), progress);
  }
  if (yield && yields) map.add(AmongPassing(*yield, filter_of(family, map, all_else)), progress);
}

std::vector<RequirementKind> AddedMeasures::failures_at(MapPoint place, const Requirements& wanted) const {
  std::vector<RequirementKind> failed;
  if (tolerance_error && wanted.max_tolerance_error < Requirements::unlimited)
    if (!(tolerance_error->at(place).value_or(Requirements::unlimited) <= wanted.max_tolerance_error))
      failed.push_back(RequirementKind::max_tolerance_error);
  if (yield && wanted.min_yield > 0 && !(yield->at(place).value_or(0) >= wanted.min_yield))
    failed.push_back(RequirementKind::min_yield);
  return failed;
}

std::optional<double> AddedMeasures::score(MapPoint place, const Requirements& wanted, Objective objective,
                                           double own) const {
  constexpr double tie = 1e-9;  // less than one sample of the largest number of them
  const bool by_yield = objective == Objective::yield, by_error = objective == Objective::tolerance_error;
  std::optional<double> error, good;
  if (tolerance_error && (by_error || by_yield || wanted.max_tolerance_error < Requirements::unlimited)) {
    error = tolerance_error->at(place);
    if (!error || !std::isfinite(*error) || *error > wanted.max_tolerance_error) return std::nullopt;
  }
  if (yield && (by_yield || wanted.min_yield > 0)) {
    good = yield->at(place);
    const double least = wanted.min_yield > 0 ? wanted.min_yield + yield_margin : 0;
    if (!good || *good < least) return std::nullopt;
  }
  if (by_error && error) return -*error;
  if (by_yield && good) return *good - tie * error.value_or(0) / (1 + error.value_or(0));
  return own;
}

}  // namespace linkwright
