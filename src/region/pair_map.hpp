#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "linkwright/core/parallel.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/region/region_map.hpp"

// What maps over pairs of grounded links have in common, in the plane and on the sphere. An axis has `dyads` and, by
// sample, `admissible_directions` and `sweep_ccw`.
namespace linkwright {

template <class Axis>
[[nodiscard]] DriverTravel driver_travel(const Axis& axis, std::size_t sample) {
  return {axis.admissible_directions[sample], axis.sweep_ccw[sample]};
}

/// Which way a driver may turn depends on its partner.
template <class Axis>
[[nodiscard]] bool pairs_decide_sense(const Axis& input, std::size_t positions) {
  if (positions != 2) return false;
  for (std::size_t i = 0; i < input.size(); ++i)
    if (input.admissible_directions[i] == (DriverTravel::ccw | DriverTravel::cw) && input.sweep_ccw[i] > 0) return true;
  return false;
}

/// For each row the column of the same grounded link, or RegionMap::no_diagonal.
template <class Dyad, class Same>
[[nodiscard]] std::vector<std::uint32_t> diagonal_of(const std::vector<Dyad>& input, const std::vector<Dyad>& output,
                                                     const Same& same) {
  std::vector<std::pair<double, std::uint32_t>> columns;
  for (std::size_t k = 0; k < output.size(); ++k)
    columns.emplace_back(output[k].coordinate, static_cast<std::uint32_t>(k));
  std::sort(columns.begin(), columns.end());
  std::vector<std::uint32_t> column_of_row(input.size(), RegionMap::no_diagonal);
  for (std::size_t row = 0; row < input.size(); ++row) {
    const Dyad& dyad = input[row];
    const auto found = std::lower_bound(columns.begin(), columns.end(), std::pair(dyad.coordinate, std::uint32_t{0}));
    if (found != columns.end() && found->first == dyad.coordinate && same(dyad, output[found->second]))
      column_of_row[row] = found->second;
  }
  return column_of_row;
}

/// Calls the kernel for the rows of a laid map, by threads where it is worth it. `task` has row_begin and row_end.
template <class KernelTask, class Kernel>
void run_rows(RegionMap& map, const KernelTask& task, const Kernel& kernel, const RegionOptions& options,
              const Progress& progress) {
  constexpr std::size_t rows_at_once = 16;              // before a thread looks whether to stop
  constexpr std::size_t cells_worth_a_thread = 30'000;  // a smaller map is ready before a second one is awake
  const std::size_t rows = map.rows();
  const int threads = rows * map.columns() < cells_worth_a_thread ? 1 : options.threads;
  parallel_for((rows + rows_at_once - 1) / rows_at_once, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      KernelTask part = task;
      part.row_begin = chunk * rows_at_once;
      part.row_end = std::min(part.row_begin + rows_at_once, rows);
      if (progress.is_cancelled())
        map.leave_empty(part.row_begin, part.row_end);
      else
        kernel(part);
    }
  });
}

}  // namespace linkwright
