#include "function_columns.hpp"

namespace linkwright {

MapAxis axis_of(const std::optional<FreeParameter>& free) {
  if (!free) return {AxisQuantity::nothing, {{"point", 0, 1}}};
  const bool scale = free->kind == FreeParameter::Kind::output_scale;
  return {scale ? AxisQuantity::output_scale : AxisQuantity::pair_output, {{"range", 0, 1}}};
}

double axis_value_of(const std::optional<FreeParameter>& free, double tau) {
  if (!free) return tau;
  const double value = free->at(tau);
  return free->kind == FreeParameter::Kind::pair_output ? degrees(value) : value;
}

}  // namespace linkwright
