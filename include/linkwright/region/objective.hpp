#pragma once

#include <string_view>

#include "linkwright/region/measure.hpp"

namespace linkwright {

/// What ranks linkages: the largest least transmission angle, the smallest link ratio, the smallest longest link; of
/// generators of a named function the smallest structural error, which no map holds: its cells are ranked by the
/// transmission angle; of spherical linkages the largest least link angle; of linkages with a straight line the longest
/// usable length over the longest link, the least deviation, the most even velocity; of all that
/// are made with tolerances the least error by them, the largest yield.
enum class Objective {
  min_transmission_angle,
  link_ratio,
  size,
  structural_error,
  link_angle,
  stroke,
  deviation,
  velocity_uniformity,
  tolerance_error,
  yield
};
/// Key in problem files: "min_transmission_angle", …
[[nodiscard]] std::string_view name(Objective objective);

/// No family measures it itself: it needs AddedMeasures.
[[nodiscard]] inline bool is_of_tolerances(Objective objective) {
  return objective == Objective::tolerance_error || objective == Objective::yield;
}

/// The measure that ranks the cells of a map; a larger or a smaller one is better, as the measure says.
[[nodiscard]] const Measure& measure_of(Objective objective);

/// The numbers that a linkage is ranked by, as a map stores them; those that its class has not stay 0.
struct RankedNumbers {
  double transmission_versine = 0;  ///< 1 − cos of the least transmission angle
  double link_ratio = 0;
  double longest_link = 0;  ///< user's unit
  double link_versine = 0;  ///< 1 − cos of the least link angle
  double stroke_over_longest = 0;
  double deviation = 0;  ///< user's unit
  double velocity_nonuniformity = 0;
};
/// Larger is better: a versine, −ratio or −longest link. Of what no family measures itself AddedMeasures scores.
[[nodiscard]] double score_of(Objective objective, const RankedNumbers& numbers);

}  // namespace linkwright
