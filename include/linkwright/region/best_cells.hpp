#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "linkwright/region/criterion.hpp"
#include "linkwright/region/hill_climb.hpp"
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

/// A cell that no other beats in both of two objectives.
struct ParetoCell {
  std::size_t row = 0, column = 0;
  std::array<double, 2> values{};  ///< of both objectives, as the map stores them
};

/// Of the cells that meet the requirements those that no other of them beats in one objective without being worse in
/// the other (V. Pareto), the best by the first objective first; of equals one. The map holds the measures of both.
[[nodiscard]] std::vector<ParetoCell> pareto_front(const RegionMap& map, const RequirementFilter& filter,
                                                   std::array<Objective, 2> objectives);

/// At most `most` ≥ 1 of a front, both ends among them, so that the steps between them are even in both objectives
/// together, each counted by its range over the front.
[[nodiscard]] std::vector<ParetoCell> spread_over(const std::vector<ParetoCell>& front, std::size_t most);

/// The best cell of each row, or of each column, of a region.
struct Ridge {
  std::vector<float> value;            ///< 0 where no cell passes
  std::vector<std::uint32_t> partner;  ///< its column (row); the first of equals
};

struct Ridges {
  Ridge input, output;  ///< by row, by column
};

/// `values` and `failures`: of each cell, row-major; a cell passes where its failures are 0.
[[nodiscard]] Ridges ridges(std::span<const float> values, std::span<const FailureBits> failures, std::size_t columns,
                            bool larger_is_better);

}  // namespace linkwright
