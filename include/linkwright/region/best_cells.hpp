#pragma once

#include <cstddef>
#include <vector>

#include "linkwright/region/hill_tops.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {

/// A map that a search for the best begins at, what of it passes, and how far apart its coordinates are.
struct SearchMap {
  const RegionMap* map = nullptr;
  const RequirementFilter* filter = nullptr;
  MapPoint step;
};

/// Cells that pass and that no neighbour of the same type, up to a hundredth of the map away, betters, best first, at
/// most `most`. Neighbours on another branch of the curve do not count. From each a hill can be climbed in the two
/// curve coordinates.
[[nodiscard]] std::vector<RankedCell> hill_tops(const RegionMap& map, const RequirementFilter& filter,
                                                Objective objective, std::size_t most);

/// The best passing cell of each tile of a `tiles` × `tiles` grid over the map, best first.
[[nodiscard]] std::vector<RankedCell> tile_bests(const RegionMap& map, const RequirementFilter& filter,
                                                 Objective objective, std::size_t tiles);

}  // namespace linkwright
