#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "linkwright/region/region_map.hpp"

namespace linkwright {

/// What a cell of a region is measured by, in the order of result files.
enum class CellProperty : std::uint8_t {
  min_transmission_angle,            ///< over the task, degrees
  min_transmission_angle_full_turn,  ///< of a crank, degrees
  link_ratio,
  longest_link,  ///< user's unit
  driver_sweep,  ///< degrees
};
inline constexpr std::size_t cell_properties = 5;

/// Key in result files: min_transmission_angle_deg, …
[[nodiscard]] std::string_view key(CellProperty property);
[[nodiscard]] std::optional<CellProperty> cell_property_named(std::string_view key);

/// True where more is better: the transmission angles.
[[nodiscard]] bool larger_is_better(CellProperty property);

/// The property of each cell of a row as files and pages have it: angles in degrees, 0 where it is not defined, never
/// NaN or infinite. `values` has a place for each column.
void row_values(const RegionMap& map, CellProperty property, std::size_t row, std::span<float> values);

}  // namespace linkwright
