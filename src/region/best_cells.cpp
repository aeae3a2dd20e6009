#include "linkwright/region/best_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "linkwright/core/precondition.hpp"

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

/// Smaller is better.
class Cost {
 public:
  Cost(const RegionMap& map, const Measure& measure)
      : values_(map.values(measure)), sign_(measure.larger_is_better ? -1 : 1) {
    require(!values_.empty() || map.rows() * map.columns() == 0, "the map has the measure");
  }
  [[nodiscard]] double of(std::size_t cell) const { return sign_ * value(cell); }
  [[nodiscard]] double value(std::size_t cell) const { return static_cast<double>(values_[cell]); }

 private:
  std::span<const float> values_;
  double sign_;
};

constexpr float nothing = -std::numeric_limits<float>::infinity();

Ridge empty_ridge(std::size_t size) { return {std::vector<float>(size, nothing), std::vector<std::uint32_t>(size, 0)}; }

void tell_values(Ridge& ridge, float sign) {
  for (float& value : ridge.value) value = value == nothing ? 0.0F : sign * value;
}

}  // namespace

std::vector<RankedCell> hill_tops(const RegionMap& map, const RequirementFilter& filter, Objective objective,
                                  std::size_t most) {
  const Ranking ranking(map, objective);
  const auto score_at = [&](std::size_t row, std::size_t column) {
    return filter.passes(row, column) ? ranking.score(map.index(row, column)) : no_score;
  };
  const std::span<const float> layers = map.values(measures::layer);
  const auto same_layer = [&](std::size_t cell, std::size_t other) {
    return layers.empty() || layers[cell] == layers[other];
  };
  const auto same_hill = [&](std::size_t row, std::size_t column, std::size_t other_row, std::size_t other_column) {
    const std::size_t cell = map.index(row, column), other = map.index(other_row, other_column);
    return map.type(cell) == map.type(other) && same_layer(cell, other) &&
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

std::vector<ParetoCell> pareto_front(const RegionMap& map, const RequirementFilter& filter,
                                     std::array<Objective, 2> objectives) {
  const Cost first(map, measure_of(objectives[0])), second(map, measure_of(objectives[1]));
  std::vector<std::size_t> cells;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column) {
      const std::size_t cell = map.index(row, column);
      if (filter.passes(row, column) && std::isfinite(first.of(cell)) && std::isfinite(second.of(cell)))
        cells.push_back(cell);
    }
  std::sort(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) {
    if (first.of(a) != first.of(b)) return first.of(a) < first.of(b);
    return second.of(a) != second.of(b) ? second.of(a) < second.of(b) : a < b;
  });
  std::vector<ParetoCell> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t cell : cells) {
    if (!(second.of(cell) < best)) continue;
    best = second.of(cell);
    front.push_back({cell / map.columns(), cell % map.columns(), {first.value(cell), second.value(cell)}});
  }
  return front;
}

std::vector<ParetoCell> spread_over(const std::vector<ParetoCell>& front, std::size_t most) {
  require(most > 0, "one cell at least");
  if (front.size() <= most) return front;
  if (most == 1) return {front.front()};
  std::array<double, 2> range{};
  for (std::size_t k = 0; k < 2; ++k) range[k] = std::abs(front.back().values[k] - front.front().values[k]);
  std::vector<double> way = {0};
  for (std::size_t i = 1; i < front.size(); ++i) {
    double step = 0;
    for (std::size_t k = 0; k < 2; ++k)
      step += range[k] > 0 ? std::abs(front[i].values[k] - front[i - 1].values[k]) / range[k] : 0;
    way.push_back(way.back() + step);
  }
  std::vector<ParetoCell> chosen;
  for (std::size_t i = 0, next = 0; i < most; ++i) {
    const double wanted = way.back() * static_cast<double>(i) / static_cast<double>(most - 1);
    while (next + 1 < front.size() && way[next] < wanted) ++next;
    if (chosen.empty() || front[next].values != chosen.back().values) chosen.push_back(front[next]);
  }
  return chosen;
}

Ridges ridges(std::span<const float> values, std::span<const FailureBits> failures, std::size_t columns,
              bool larger_is_better) {
  const std::size_t rows = columns == 0 ? 0 : values.size() / columns;
  const float sign = larger_is_better ? 1.0F : -1.0F;
  Ridges found{empty_ridge(rows), empty_ridge(columns)};
  for (std::size_t row = 0; row < rows; ++row) {
    float best = nothing;
    std::uint32_t partner = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      const std::size_t cell = row * columns + column;
      if (failures[cell] != 0) continue;
      const float value = sign * values[cell];
      if (value > best) {
        best = value;
        partner = static_cast<std::uint32_t>(column);
      }
      if (value > found.output.value[column]) {
        found.output.value[column] = value;
        found.output.partner[column] = static_cast<std::uint32_t>(row);
      }
    }
    found.input.value[row] = best;
    found.input.partner[row] = partner;
  }
  tell_values(found.input, sign);
  tell_values(found.output, sign);
  return found;
}

}  // namespace linkwright
