#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// How a map is climbed: what stands at each place of it, and over which stretch.
struct Hill {
  /// Score of the design at (first, second) coordinate, larger is better; nothing where there is none, or none that is
  /// allowed.
  std::function<std::optional<double>(double, double)> score_at;
  AxisStretch first, second;
};

struct HillClimbOptions {
  std::array<double, 2> first_step{};  ///< along each coordinate, the distance of two cells of the map; 0: stays
  double resolution = 1e-3;            ///< shares of the first steps to which the top is found
  int max_evaluations = 60;            ///< of each line search
  double across = 1e-3;                ///< shares of a step to which the best second coordinate is found each time
};

struct HillTop {
  std::array<double, 2> place{};  ///< on the stretches
  double score = 0;
  int evaluations = 0;
  SearchEnd end = SearchEnd::settled;  ///< evaluation_limit: it was still getting better, or was cancelled
};

/// The top of the hill on which a place with a score stands. A design is as good as the worst of several smooth
/// functions, so hills have sharp ridges on which steps in fixed directions get stuck: for each value of the first
/// coordinate the best value of the second is sought, and each of the two searches is on a line. Cancelled: the best so
/// far.
[[nodiscard]] HillTop climb_hill(const Hill& hill, std::array<double, 2> start, double score,
                                 const HillClimbOptions& options, const Progress& progress = {});

/// A cell that passes, and how good it is: larger is better for every objective.
struct RankedCell {
  std::size_t row = 0, column = 0;
  double score = 0;
};

/// Best first; of equals the one that comes first in the map.
[[nodiscard]] inline bool ranks_before(const RankedCell& a, const RankedCell& b) {
  if (a.score != b.score) return a.score > b.score;
  return a.row != b.row ? a.row < b.row : a.column < b.column;
}

/// Score of a cell that does not pass.
inline constexpr double no_score = -std::numeric_limits<double>::infinity();

struct HillTopOptions {
  std::size_t reach = 1;      ///< cells, in each direction, that a top is compared with
  std::size_t max_count = 0;  ///< how many tops, at most
  int threads = 0;            ///< 0: as many as the machine has
};

/// Cells that no other within reach betters, best first. `score(row, column)` is no_score where a cell does not pass;
/// `same_hill(row, column, other_row, other_column)` says whether two cells are to be compared. Both are called from
/// several threads.
template <class Score, class SameHill>
[[nodiscard]] std::vector<RankedCell> hill_tops(std::size_t rows, std::size_t columns, const HillTopOptions& options,
                                                const Score& score, const SameHill& same_hill) {
  const auto first = [](std::size_t index, std::size_t reach) { return index < reach ? 0 : index - reach; };
  const auto nothing_better_within = [&](std::size_t reach, const RankedCell& cell) {
    const std::size_t last_row = std::min(cell.row + reach, rows - 1),
                      last_column = std::min(cell.column + reach, columns - 1);
    for (std::size_t row = first(cell.row, reach); row <= last_row; ++row)
      for (std::size_t column = first(cell.column, reach); column <= last_column; ++column)
        if (!(row == cell.row && column == cell.column) && ranks_before({row, column, score(row, column)}, cell) &&
            same_hill(cell.row, cell.column, row, column))
          return false;
    return true;
  };

  std::vector<RankedCell> found;
  std::mutex adding;
  parallel_for(rows, options.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<RankedCell> part;
    for (std::size_t row = begin; row < end; ++row)
      for (std::size_t column = 0; column < columns; ++column) {
        const RankedCell cell{row, column, score(row, column)};
        // The next neighbours first: they settle nearly all cells. A ridge across the grid has many small tops.
        if (cell.score > no_score && nothing_better_within(1, cell) &&
            (options.reach <= 1 || nothing_better_within(options.reach, cell)))
          part.push_back(cell);
      }
    const std::lock_guard lock(adding);
    found.insert(found.end(), part.begin(), part.end());
  });
  std::sort(found.begin(), found.end(), ranks_before);
  if (found.size() > options.max_count) found.resize(options.max_count);
  return found;
}

}  // namespace linkwright
