#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/planar/missed_box.hpp"
#include "linkwright/region/measure.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirement_filter.hpp"
#include "linkwright/region/ridge.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright::wasm {

/// A map under requirements, coloured by a property.
class EvaluatedMap {
 public:
  /// Takes over the memory of the map before.
  void classify(const std::function<void(RegionMap&)>& fill);
  /// Adds a column to the map, or takes it anew.
  void add(const CellMeasure& measure) { map_.add(measure); }
  /// `filter` of map().
  void evaluate(const RequirementFilter& filter);
  /// Told where nothing is left: boxes that the curve misses, what was looked at inside the windows, and what would
  /// leave something there or on the map.
  void note_nothing_left(std::vector<MissedBox> missed, const InsideWindows& inside, std::vector<Relaxation> relax);
  /// One of the map's measures, or the first where it has no such.
  void measure(std::string_view key);
  /// What `fill` writes of the cells; 0: not defined.
  void show(const std::function<void(std::span<float> values)>& fill, bool larger_is_better = false);

  [[nodiscard]] const RegionMap& map() const { return map_; }
  [[nodiscard]] const RegionCounts& counts() const { return counts_; }
  [[nodiscard]] const std::vector<FailureBits>& fails() const { return fails_; }
  [[nodiscard]] const std::vector<float>& values() const { return values_; }
  [[nodiscard]] const Ridges& ridges() const { return ridges_; }
  [[nodiscard]] const RequirementCensus& census() const { return census_; }

  /// Census of the protocol.
  [[nodiscard]] std::string census_json() const;

 private:
  RegionMap map_;
  RegionCounts counts_;
  std::vector<FailureBits> fails_;
  std::vector<float> values_;
  RequirementCensus census_;
  std::vector<Relaxation> relax_;
  std::optional<JointRelaxation> relax_together_;
  std::vector<MissedBox> missed_boxes_;
  InsideWindows inside_;
  Ridges ridges_;
};

}  // namespace linkwright::wasm
