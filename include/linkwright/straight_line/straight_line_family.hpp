#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/straight_line/line_design.hpp"
#include "linkwright/straight_line/line_measuring.hpp"
#include "linkwright/straight_line/line_worth.hpp"
#include "linkwright/straight_line/straight_line_task.hpp"

namespace linkwright {

/// A place of a map of straight lines as people read it: degrees, or the user's unit of length.
struct MapNumbers {
  int layer = 0;
  std::array<double, 2> at{};
};

/// The linkages that a case of straight lines leaves open over two numbers. A place may have several: the axis of the
/// rows then has a branch to each layer, over the same numbers.
class StraightLineFamily : public LinkageFamily {
 public:
  /// `task` without mistakes. `window`: the ranges of both axes, as people read them; nothing: lengths over ± 4 times
  /// the size of the task, angles over all of them.
  StraightLineFamily(StraightLineTask task, LineMeasuring measuring, const std::optional<MapWindow>& window = {});

  [[nodiscard]] const LinkageClass& linkages() const override { return straight_line_linkages; }
  [[nodiscard]] int layers() const;
  /// What its linkages are: "alpha", "AB", …; empty where there is one layer.
  [[nodiscard]] std::string_view layer_name(int layer) const;
  /// Points of contact that its linkages have at least.
  [[nodiscard]] int contact() const;
  [[nodiscard]] const StraightLineTask& task() const { return task_; }
  [[nodiscard]] const LineMeasuring& measuring() const { return measuring_; }
  /// The stroke over which linkages are judged, as the way from where the point is: the one that is asked for, of
  /// contacts at places from the first to the last, of a symmetric λ its own; nothing: none.
  [[nodiscard]] std::optional<std::array<double, 2>> stroke() const;
  /// What keeps a linkage from passing the contacts at places; none of other cases.
  [[nodiscard]] Defects defects(const TracingFourBar& linkage) const;
  /// The range of an axis, as people read it.
  [[nodiscard]] std::array<double, 2> range(Side side) const;

  [[nodiscard]] MapNumbers place_of(MapPoint point) const;
  /// The place on the map; nothing where there is no such layer or a number is off its axis.
  [[nodiscard]] std::optional<MapPoint> point_of(const MapNumbers& place) const;

  [[nodiscard]] LineDesign design(MapPoint point) const;

  [[nodiscard]] double axis_value(Side side, double coordinate) const override;
  /// `count` to each layer.
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] std::span<const Measure> measures() const override { return straight_line_measures; }
  /// Measured exactly, but for the usable length by the other measure and the contact.
  [[nodiscard]] CellAt cells(bool respect_direction) const override;
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;

  /// Its error is looked at in so many places along the line, the ends being worst: those listed, and those of a map.
  static constexpr int places_of_line = 41, places_of_cell = 9;
  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint place) const override;
  /// Of a linkage known already, at evenly laid places: over the stroke that is asked for; where there is none, or the
  /// point does not go so far, over the usable length.
  [[nodiscard]] std::optional<LinkageOutput> output_of(const TracingFourBar& linkage, int places) const;
  [[nodiscard]] bool outputs_take_long() const override { return true; }

 private:
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  StraightLineTask task_;
  LineMeasuring measuring_;
  std::array<std::array<double, 2>, 2> ranges_;  ///< of both axes, radians or user's unit
};

}  // namespace linkwright
