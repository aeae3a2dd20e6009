#include "linkwright/region/best_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace linkwright {
namespace {

class Ranking {
 public:
  Ranking(const RegionMap& map, Objective objective)
      : rank_(rank_of(objective, map.measures())), values_(map.values(map.measures()[rank_.measure])) {}

  [[nodiscard]] double score(std::size_t cell) const { return rank_.sign * static_cast<double>(values_[cell]); }

 private:
  Rank rank_;
  std::span<const float> values_;
};

bool same_branch(double tau, double other) { return std::floor(tau) == std::floor(other); }

}  // namespace

std::vector<RankedCell> hill_tops(const RegionMap& map, const RequirementFilter& filter, Objective objective,
                                  std::size_t most) {
  const Ranking ranking(map, objective);
  const auto score_at = [&](std::size_t row, std::size_t column) {
    return filter.passes(row, column) ? ranking.score(map.index(row, column)) : no_score;
  };
  const auto same_hill = [&](std::size_t row, std::size_t column, std::size_t other_row, std::size_t other_column) {
    return map.type(map.index(row, column)) == map.type(map.index(other_row, other_column)) &&
           same_branch(map.input_coordinates()[row], map.input_coordinates()[other_row]) &&
           same_branch(map.output_coordinates()[column], map.output_coordinates()[other_column]);
  };
  const std::size_t reach = std::max<std::size_t>(map.rows() / 100, 1);
  return hill_tops(map.rows(), map.columns(), {reach, most, map.threads()}, score_at, same_hill);
}

std::vector<RankedCell> tile_bests(const RegionMap& map, const RequirementFilter& filter, Objective objective,
                                   std::size_t tiles) {
  const auto tile_of = [&](std::size_t index, std::size_t size) { return index * tiles / size; };
  const Ranking ranking(map, objective);
  std::vector<std::optional<RankedCell>> best(tiles * tiles);
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      if (!filter.passes(row, column)) continue;
      const RankedCell cell{row, column, ranking.score(map.index(row, column))};
      auto& held = best[tile_of(row, map.rows()) * tiles + tile_of(column, map.columns())];
      if (!held || ranks_before(cell, *held)) held = cell;
    }
  std::vector<RankedCell> found;
  for (const auto& cell : best)
    if (cell) found.push_back(*cell);
  std::sort(found.begin(), found.end(), ranks_before);
  return found;
}

}  // namespace linkwright
