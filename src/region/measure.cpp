#include "linkwright/region/measure.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {
namespace {

void angles_in_degrees(std::span<const float> versines, std::span<float> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        versines[i] > 0 ? static_cast<float>(degrees(angle_of_versine(static_cast<double>(versines[i])))) : 0.0F;
}

void finite_values(const Measure& measure, std::span<const float> from, std::span<float> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] =
        std::isfinite(from[i]) ? static_cast<float>(readable_value(measure, static_cast<double>(from[i]))) : 0.0F;
}

void sweeps_in_degrees(const RegionMap& map, std::size_t row, std::span<float> values) {
  for (std::size_t column = 0; column < values.size(); ++column)
    values[column] = static_cast<float>(degrees(map.driver_sweep(row, column)));
}

}  // namespace

double angle_of_versine(double versine) { return 2 * std::asin(std::sqrt(std::min(versine, 2.0) / 2)); }

double versine_of_angle(double angle) {
  const double half = std::sin(angle / 2);
  return 2 * half * half;
}

double readable_value(const Measure& measure, double stored) {
  switch (measure.stored) {
    case Measure::Stored::as_versine:
      return degrees(angle_of_versine(stored));
    case Measure::Stored::as_angle:
      return degrees(stored);
    default:
      return stored;
  }
}

void row_values(const RegionMap& map, const Measure& measure, std::size_t row, std::span<float> values) {
  require(values.size() == map.columns(), "there is a place for each column");
  if (measure == measures::driver_sweep) return sweeps_in_degrees(map, row, values);
  const std::span<const float> held = map.values(measure);
  require(!held.empty() || values.empty(), "the map has the measure");
  const std::span<const float> of_row = held.subspan(map.index(row, 0), map.columns());
  if (measure.stored == Measure::Stored::as_versine) return angles_in_degrees(of_row, values);
  finite_values(measure, of_row, values);
}

}  // namespace linkwright
