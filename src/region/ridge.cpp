#include "linkwright/region/ridge.hpp"

#include <limits>

namespace linkwright {
namespace {

constexpr float nothing = -std::numeric_limits<float>::infinity();

Ridge empty_ridge(std::size_t size) { return {std::vector<float>(size, nothing), std::vector<std::uint32_t>(size, 0)}; }

void tell_values(Ridge& ridge, float sign) {
  for (float& value : ridge.value) value = value == nothing ? 0.0F : sign * value;
}

}  // namespace

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
