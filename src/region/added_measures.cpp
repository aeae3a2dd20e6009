#include "linkwright/region/added_measures.hpp"

#include <cmath>

namespace linkwright {

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
    if (!good || *good < wanted.min_yield) return std::nullopt;
  }
  if (by_error && error) return -*error;
  if (by_yield && good) return *good - tie * error.value_or(0) / (1 + error.value_or(0));
  return own;
}

}  // namespace linkwright
