#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "linkwright/region/map_axis.hpp"
#include "linkwright/region/measure.hpp"

namespace linkwright {

class RegionMap;

/// Numbers that are worked out together for the cells of a map.
class CellMeasures {
 public:
  CellMeasures() = default;
  CellMeasures(const CellMeasures&) = delete;
  CellMeasures& operator=(const CellMeasures&) = delete;
  virtual ~CellMeasures() = default;

  /// Writes the cells of a row: to each measure a span with a place to each column; called from several threads.
  using Rows = std::function<void(std::size_t row, std::span<const std::span<float>> values)>;
  /// Of measures that are among these, and a map of the family. Refers to the map.
  [[nodiscard]] virtual Rows rows_of(const RegionMap& map, std::span<const Measure> measures) const = 0;
};

/// A number of the linkages of a family that the family itself does not measure: what else is asked about them, such as
/// how they are made. RegionMap::add() gives it a column.
class CellMeasure {
 public:
  explicit CellMeasure(const Measure& measure) : measure_(measure) {}
  CellMeasure(const CellMeasure&) = delete;
  CellMeasure& operator=(const CellMeasure&) = delete;
  virtual ~CellMeasure() = default;

  [[nodiscard]] const Measure& measure() const { return measure_; }

  /// Of the linkage at a place, as a map stores it; nothing where there is none.
  [[nodiscard]] virtual std::optional<double> at(MapPoint place) const = 0;

  /// Writes the cells of a row, `values` having a place to each column; called from several threads.
  using Rows = std::function<void(std::size_t row, std::span<float> values)>;
  /// Of a map of the family; what rows or columns share is worked out once. Refers to the map. By default at() of each
  /// cell that is not degenerate, 0 for the others.
  [[nodiscard]] virtual Rows rows_of(const RegionMap& map) const;

 private:
  Measure measure_;
};

}  // namespace linkwright
