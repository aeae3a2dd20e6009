#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/simd.hpp"
#include "linkwright/straight_line/line_measuring.hpp"
#include "linkwright/straight_line/line_shape.hpp"
#include "linkwright/straight_line/line_worth.hpp"
#include "linkwright/straight_line/straight_line_family.hpp"

namespace linkwright {

/// What a straight line is worth, quickly, as maps have it, or exactly.
struct LineEstimate {
  double usable_stroke = 0, usable_strip = 0;
  double deviation = std::numeric_limits<double>::infinity();  ///< over the stroke, or the usable length; infinite
                                                               ///< where it is not reached
  double min_transmission_sine = 0;  ///< of the angle, over the same; where it is not reached over the usable length
  double velocity_nonuniformity = 0;
  double contact_coefficient = 0;  ///< |K| of s^contact
  double strip_middle = 0;         ///< s

  /// By the measure that counts.
  [[nodiscard]] double usable(LineMeasure by) const { return by == LineMeasure::strip ? usable_strip : usable_stroke; }
  [[nodiscard]] LineWorth worth(LineMeasure by) const {
    return {usable(by), deviation, std::asin(std::min(min_transmission_sine, 1.0)), velocity_nonuniformity};
  }
};

/// What the linkages of an estimate have in common.
struct LineEstimateTask {
  Point direction{1, 0};  ///< of the line
  int contact = 4;
  LineMeasuring measuring;
  std::optional<std::array<double, 2>> stroke{};  ///< over which lines are judged
  Simd simd = Simd::automatic;
};

/// `estimates` has a place for each linkage. `deviations`: of each, instead of what the task measures by; none: as it
/// does. Exact where steps along the path, shorter and more the second time, do not tell it: where it is longer than
/// they lead, or bends too sharply.
void estimate_lines(std::span<const TracingFourBar> linkages, const LineEstimateTask& task,
                    std::span<LineEstimate> estimates, std::span<const double> deviations = {});

/// By StraightPath, but for the contact coefficient; the usable length by the task's measure or `by_both`. Nothing
/// where the point rests or runs across the line.
[[nodiscard]] std::optional<LineEstimate> exact_line(const TracingFourBar& linkage, const LineEstimateTask& task,
                                                     double deviation, bool by_both = false);

/// Of a family's maps.
[[nodiscard]] LineEstimateTask estimate_task(const StraightLineFamily& family, Simd simd = Simd::automatic);

/// A linkage of the atlas: one of those of its shape.
struct AtlasLinkage {
  LineShape shape;
  int layer = 0;
};

/// The best that long searches have found (data/atlas/straight_lines.csv), with which others begin.
[[nodiscard]] std::vector<AtlasLinkage> line_atlas(ShapeKind kind);

}  // namespace linkwright
