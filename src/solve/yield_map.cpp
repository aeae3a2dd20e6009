#include "solve/yield_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwright/region/region_map.hpp"

namespace linkwright {
namespace {

constexpr std::size_t coarsest = 16;  // cells a side

std::size_t corner(std::size_t place, std::size_t side) { return place / side * side; }

}  // namespace

YieldMap::YieldMap(std::size_t rows, std::size_t columns, std::vector<std::uint8_t> wanted)
    : rows_(rows),
      columns_(columns),
      wanted_(std::move(wanted)),
      values_(rows * columns, std::numeric_limits<float>::quiet_NaN()) {
  std::vector<std::uint8_t> taken(values_.size());
  for (std::size_t side = coarsest; side > 0; side /= 2)
    for (std::size_t row = 0; row < rows_; row += side)
      for (std::size_t column = 0; column < columns_; column += side) {
        const std::size_t cell = row * columns_ + column;
        if (taken[cell] || !wanted_[cell]) continue;
        taken[cell] = 1;
        order_.push_back(static_cast<std::uint32_t>(cell));
      }
}

void YieldMap::advance(std::size_t cells, const CellMeasure& yield, std::span<const double> input,
                       std::span<const double> output) {
  for (const std::size_t end = std::min(next_ + cells, order_.size()); next_ < end; ++next_) {
    const std::size_t cell = order_[next_];
    values_[cell] = static_cast<float>(yield.at({input[cell / columns_], output[cell % columns_]}).value_or(0));
  }
}

std::vector<float> YieldMap::shown() const {
  std::vector<float> shown(values_.size());
  for (std::size_t cell = 0; cell < shown.size(); ++cell) {
    if (!wanted_[cell]) continue;
    const std::size_t row = cell / columns_, column = cell % columns_;
    for (std::size_t side = 1; side <= coarsest; side *= 2) {
      const float known = values_[corner(row, side) * columns_ + corner(column, side)];
      if (std::isnan(known)) continue;
      shown[cell] = known;
      break;
    }
  }
  return shown;
}

CellMeasure::Rows KnownYields::rows_of(const RegionMap& map) const {
  return [this, &map](std::size_t row, std::span<float> values) {
    const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(map.index(row, 0));
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(values.size()), values.begin());
  };
}

}  // namespace linkwright
