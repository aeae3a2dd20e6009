#include "linkwright/region/best_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>

#include "linkwright/core/parallel.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 4> objective_names = {"min_transmission_angle", "link_ratio", "size",
                                                             "structural_error"};

double score(const RegionMap& map, Objective objective, std::size_t cell) {
  return score_of(objective, static_cast<double>(map.transmission_versines()[cell]),
                  static_cast<double>(map.link_ratios()[cell]), static_cast<double>(map.longest_links()[cell]));
}

// Best first; of equals the one that comes first in the map.
bool better(const RankedCell& a, const RankedCell& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.row != b.row ? a.row < b.row : a.column < b.column;
}

bool same_branch(double tau, double other) { return std::floor(tau) == std::floor(other); }

class HillTopTest {
 public:
  HillTopTest(const RegionMap& map, const RequirementFilter& filter, Objective objective)
      : map_(map), filter_(filter), objective_(objective), reach_(std::max<std::size_t>(map.rows() / 100, 1)) {}

  // The next neighbours first: they settle nearly all cells. A ridge across the grid has many small tops.
  [[nodiscard]] bool operator()(const RankedCell& cell) const {
    return nothing_better_within(1, cell) && (reach_ == 1 || nothing_better_within(reach_, cell));
  }

 private:
  [[nodiscard]] bool nothing_better_within(std::size_t reach, const RankedCell& cell) const {
    const auto first = [&](std::size_t index) { return index < reach ? 0 : index - reach; };
    const auto last = [&](std::size_t index, std::size_t size) { return std::min(index + reach, size - 1); };
    for (std::size_t row = first(cell.row); row <= last(cell.row, map_.rows()); ++row)
      for (std::size_t column = first(cell.column); column <= last(cell.column, map_.columns()); ++column)
        if (!(row == cell.row && column == cell.column) && beats(row, column, cell)) return false;
    return true;
  }

  [[nodiscard]] bool beats(std::size_t row, std::size_t column, const RankedCell& cell) const {
    const std::size_t other = map_.index(row, column);
    if (map_.type(other) != map_.type(map_.index(cell.row, cell.column))) return false;
    if (!same_branch(map_.input_coordinates()[row], map_.input_coordinates()[cell.row])) return false;
    if (!same_branch(map_.output_coordinates()[column], map_.output_coordinates()[cell.column])) return false;
    const RankedCell neighbour{row, column, score(map_, objective_, other)};
    return better(neighbour, cell) && filter_.passes(row, column);
  }

  const RegionMap& map_;
  const RequirementFilter& filter_;
  Objective objective_;
  std::size_t reach_;
};

}  // namespace

std::string_view name(Objective objective) { return objective_names[static_cast<std::size_t>(objective)]; }

double score_of(Objective objective, double versine, double link_ratio, double longest) {
  switch (objective) {
    case Objective::min_transmission_angle:
    case Objective::structural_error:
      return versine;
    case Objective::link_ratio:
      return -link_ratio;
    default:
      return -longest;
  }
}

std::vector<RankedCell> hill_tops(const RegionMap& map, const RequirementFilter& filter, Objective objective,
                                  std::size_t most) {
  std::vector<RankedCell> found;
  std::mutex adding;
  const HillTopTest is_top(map, filter, objective);
  parallel_for(map.rows(), 0, [&](std::size_t begin, std::size_t end) {
    std::vector<RankedCell> part;
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < map.columns(); ++column) {
        if (!filter.passes(row, column)) continue;
        const RankedCell cell{row, column, score(map, objective, map.index(row, column))};
        if (is_top(cell)) part.push_back(cell);
      }
    const std::lock_guard lock(adding);
    found.insert(found.end(), part.begin(), part.end());
  });
  std::sort(found.begin(), found.end(), better);
  if (found.size() > most) found.resize(most);
  return found;
}

std::vector<RankedCell> tile_bests(const RegionMap& map, const RequirementFilter& filter, Objective objective,
                                   std::size_t tiles) {
  const auto tile_of = [&](std::size_t index, std::size_t size) { return index * tiles / size; };
  std::vector<std::optional<RankedCell>> best(tiles * tiles);
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      if (!filter.passes(row, column)) continue;
      const RankedCell cell{row, column, score(map, objective, map.index(row, column))};
      auto& held = best[tile_of(row, map.rows()) * tiles + tile_of(column, map.columns())];
      if (!held || better(cell, *held)) held = cell;
    }
  std::vector<RankedCell> found;
  for (const auto& cell : best)
    if (cell) found.push_back(*cell);
  std::sort(found.begin(), found.end(), better);
  return found;
}

}  // namespace linkwright
