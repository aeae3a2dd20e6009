#include "listed_cells.hpp"

#include <algorithm>
#include <atomic>
#include <string>

#include "linkwright/core/parallel.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {

MapAxis axis_of_found(AxisQuantity quantity, std::string_view what, std::size_t count) {
  MapAxis axis{quantity, {}};
  for (std::size_t i = 0; i < count; ++i)
    axis.branches.push_back({std::string(what), static_cast<double>(i), static_cast<double>(i + 1)});
  return axis;
}

std::vector<std::size_t> spread_numbers(std::size_t count, std::size_t all, bool closed) {
  const std::size_t some = std::min(count, all);
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < some; ++k)
    chosen.push_back(closed ? k * all / some : k * (all - 1) / std::max<std::size_t>(1, some - 1));
  return chosen;
}

namespace {

void fill_row(const FourBarFamily& family, const BarsAt& bars_at, RegionMap& map, std::size_t row, double input,
              std::span<const double> output, bool respect_direction, const Progress& progress) {
  const LinkageFamily::CellAt cell_at = family.cells(respect_direction);
  for (std::size_t column = 0; column < output.size() && !progress.is_cancelled(); ++column) {
    const MapPoint place{input, output[column]};
    const auto cell = cell_at(place, [](const Cell&) { return true; });
    const auto bars = cell ? bars_at(place) : std::nullopt;
    if (!bars) continue;
    const RegionMap::Cells to = map.cells(row, column);
    *to.type = static_cast<std::uint8_t>(cell->type);
    *to.defects = cell->defects.bits;
    for (std::size_t k = 0; k < family.measures().size(); ++k) *to.measures[k] = static_cast<float>(cell->values[k]);
    const DriverSequence order =
        driver_sequence(bars->input_fixed, bars->input_moving, family.user_poses(place, *bars), respect_direction);
    map.set_driver(row, column, {order.senses(), static_cast<float>(order.sweep_ccw)});
  }
}

}  // namespace

void fill_one_by_one(const FourBarFamily& family, const BarsAt& bars_at, RegionMap& map, std::span<const double> input,
                     std::span<const double> output, bool respect_direction, const RegionOptions& options,
                     const Progress& progress) {
  constexpr bool of_pairs = false;
  map.lay(input, output, family.measures(), of_pairs, options);
  map.give_each_cell_a_driver();
  std::atomic<std::size_t> done = 0;
  parallel_for(input.size(), options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      map.leave_empty(row, row + 1);
      fill_row(family, bars_at, map, row, input[row], output, respect_direction, progress);
      progress(static_cast<double>(++done) / static_cast<double>(input.size()));
    }
  });
}

}  // namespace linkwright
