#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "linkwright/region/measure.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// What ranks linkages: the largest least transmission angle, the smallest link ratio, the smallest longest link; of
/// generators of a named function the smallest structural error, which no map holds: its cells are ranked by the
/// transmission angle; of spherical linkages the largest least link angle; of linkages with a straight line the longest
/// usable length over the longest link, the least deviation, the most even velocity; of all that
/// are made with tolerances the least error by them, the largest yield; of all that carry loads the least hand force,
/// the best hold, the least force of a pin, the least torque; of paths that pass near points, and of motions past near
/// poses, the smallest error.
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
  yield,
  hand_force,
  hold_open,
  pin_force,
  torque,
  path_error,
  near_error,
  end  ///< none: how many there are
};
/// All there are.
[[nodiscard]] std::span<const Objective> objectives();
/// Key in problem files: "min_transmission_angle", …
[[nodiscard]] std::string_view name(Objective objective);
/// What the best linkage has: "largest minimum transmission angle", "smallest link ratio", …
[[nodiscard]] std::string_view superlative(Objective objective);

/// The measure that ranks the cells of a map; a larger or a smaller one is better, as the measure says.
[[nodiscard]] const Measure& measure_of(Objective objective);
/// No family measures it itself: it needs AddedMeasures.
[[nodiscard]] inline bool is_of_analysis(Objective objective) { return measure_of(objective).is_added; }

/// What ranks cells: one of their measures, the larger the better once multiplied by `sign`.
struct Rank {
  std::size_t measure = 0;
  double sign = 1;
  [[nodiscard]] double score(const MapCell& cell) const { return sign * cell.values[measure]; }
};
/// Among the measures of a family or a map, which hold the transmission angle; what they do not hold AddedMeasures
/// scores, and alone it is the transmission angle that ranks.
[[nodiscard]] Rank rank_of(Objective objective, std::span<const Measure> measures);

}  // namespace linkwright
