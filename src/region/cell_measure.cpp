#include "linkwright/region/cell_measure.hpp"

#include "linkwright/region/region_map.hpp"

namespace linkwright {

CellMeasure::Rows CellMeasure::rows_of(const RegionMap& map) const {
  return [this, &map](std::size_t row, std::span<float> values) {
    for (std::size_t column = 0; column < values.size(); ++column) {
      const bool is_whole = map.type(map.index(row, column)) != LinkageType::degenerate;
      const auto found = is_whole ? at({map.input_coordinates()[row], map.output_coordinates()[column]}) : std::nullopt;
      values[column] = static_cast<float>(found.value_or(0));
    }
  };
}

}  // namespace linkwright
