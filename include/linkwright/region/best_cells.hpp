#pragma once

#include <cstddef>
#include <vector>

#include "linkwright/region/hill_tops.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {

/// What ranks linkages: the largest least transmission angle, the smallest link ratio, the smallest longest link; of
/// generators of a named function the smallest structural error, which no map holds: its cells are ranked by the
/// transmission angle.
enum class Objective { min_transmission_angle, link_ratio, size, structural_error };
/// Key in problem files: "min_transmission_angle", …
[[nodiscard]] std::string_view name(Objective objective);

/// The measure that ranks the cells of a map; a larger or a smaller one is better, as the measure says.
[[nodiscard]] const Measure& measure_of(Objective objective);
/// Score of a linkage: 1 − cos γ, −ratio or −longest link.
[[nodiscard]] double score_of(Objective objective, double versine, double link_ratio, double longest);

/// Cells that pass and that no neighbour of the same type, up to a hundredth of the map away, betters, best first, at
/// most `most`. Neighbours on another branch of the curve do not count. From each a hill can be climbed in the two
/// curve coordinates.
[[nodiscard]] std::vector<RankedCell> hill_tops(const RegionMap& map, const RequirementFilter& filter,
                                                Objective objective, std::size_t most);

/// The best passing cell of each tile of a `tiles` × `tiles` grid over the map, best first.
[[nodiscard]] std::vector<RankedCell> tile_bests(const RegionMap& map, const RequirementFilter& filter,
                                                 Objective objective, std::size_t tiles);

}  // namespace linkwright
