#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "linkwright/region/cell_measure.hpp"
#include "linkwright/region/requirement_filter.hpp"

namespace linkwright {

/// The yields of a map, cell by cell and coarse to fine, so that something can be seen before all are sampled. Cells
/// that fail what else is required are passed over.
class YieldMap {
 public:
  /// Of a map of that many cells, of which those of `wanted` are to be sampled.
  YieldMap(std::size_t rows, std::size_t columns, std::vector<std::uint8_t> wanted);

  /// Samples the next so many cells, `input` and `output` being the coordinates of the rows and columns.
  void advance(std::size_t cells, const CellMeasure& yield, std::span<const double> input,
               std::span<const double> output);

  [[nodiscard]] std::size_t done() const { return next_; }
  [[nodiscard]] std::size_t total() const { return order_.size(); }
  /// By cell; NaN where it is not sampled.
  [[nodiscard]] const std::vector<float>& values() const { return values_; }
  /// The same for eyes: where a cell is not sampled yet, but wanted, the value of the coarser one that stands for it; 0
  /// where nothing is known.
  [[nodiscard]] std::vector<float> shown() const;

 private:
  std::size_t rows_, columns_, next_ = 0;
  std::vector<std::uint8_t> wanted_;
  std::vector<std::uint32_t> order_;
  std::vector<float> values_;
};

/// What is known so far as a measure of the map.
class KnownYields : public CellMeasure {
 public:
  /// Refers to the values, by cell.
  explicit KnownYields(const std::vector<float>& values) : CellMeasure(measures::yield), values_(values) {}
  [[nodiscard]] std::optional<double> at(MapPoint /*place*/) const override { return std::nullopt; }
  [[nodiscard]] Rows rows_of(const RegionMap& map) const override;

 private:
  const std::vector<float>& values_;
};

}  // namespace linkwright
