#include "linkwright/region/cell_property.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, cell_properties> property_keys = {
    "min_transmission_angle_deg", "min_transmission_angle_full_turn_deg", "link_ratio", "longest_link",
    "driver_sweep_deg"};

void angles_in_degrees(std::span<const float> versines, std::span<float> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        versines[i] > 0 ? static_cast<float>(degrees(angle_of_versine(static_cast<double>(versines[i])))) : 0.0F;
}

void finite_values(std::span<const float> from, std::span<float> values) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::isfinite(from[i]) ? from[i] : 0.0F;
}

void sweeps_in_degrees(const RegionMap& map, std::size_t row, std::span<float> values) {
  for (std::size_t column = 0; column < values.size(); ++column)
    values[column] = static_cast<float>(degrees(map.driver_sweep(row, column)));
}

}  // namespace

std::string_view key(CellProperty property) { return property_keys[static_cast<std::size_t>(property)]; }

std::optional<CellProperty> cell_property_named(std::string_view key) {
  const auto found = std::find(property_keys.begin(), property_keys.end(), key);
  if (found == property_keys.end()) return std::nullopt;
  return static_cast<CellProperty>(found - property_keys.begin());
}

bool larger_is_better(CellProperty property) {
  return property == CellProperty::min_transmission_angle || property == CellProperty::min_transmission_angle_full_turn;
}

void row_values(const RegionMap& map, CellProperty property, std::size_t row, std::span<float> values) {
  require(values.size() == map.columns(), "there is a place for each column");
  const auto of_row = [&](std::span<const float> column) { return column.subspan(map.index(row, 0), map.columns()); };
  switch (property) {
    case CellProperty::min_transmission_angle:
      return angles_in_degrees(of_row(map.transmission_versines()), values);
    case CellProperty::min_transmission_angle_full_turn:
      return angles_in_degrees(of_row(map.full_turn_versines()), values);
    case CellProperty::link_ratio:
      return finite_values(of_row(map.link_ratios()), values);
    case CellProperty::longest_link:
      return finite_values(of_row(map.longest_links()), values);
    case CellProperty::driver_sweep:
      return sweeps_in_degrees(map, row, values);
  }
}

}  // namespace linkwright
