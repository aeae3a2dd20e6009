#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "linkwright/core/simd.hpp"
#include "linkwright/straight_line/line_measuring.hpp"
#include "linkwright/straight_line/line_worth.hpp"
#include "linkwright/straight_line/straight_line_family.hpp"

namespace linkwright {

/// What a straight line is worth, quickly, as maps have it; StraightPath has it exactly.
struct LineEstimate {
  double usable_stroke = 0, usable_strip = 0;
  double deviation = 0;              ///< over the stroke, or the usable length; infinite where it is not reached
  double min_transmission_sine = 0;  ///< of the angle, over the usable length
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
  bool by_input = false;  ///< the pole is at infinity, and the coupler does not turn
  LineMeasuring measuring;
  std::optional<std::array<double, 2>> stroke{};  ///< over which deviations are looked at
  Simd simd = Simd::automatic;
};

/// `estimates` has a place for each linkage. `deviations`: of each, instead of what the task measures by; none: as it
/// does.
void estimate_lines(std::span<const TracingFourBar> linkages, const LineEstimateTask& task,
                    std::span<LineEstimate> estimates, std::span<const double> deviations = {});

/// Of a family's maps.
[[nodiscard]] LineEstimateTask estimate_task(const StraightLineFamily& family, Simd simd = Simd::automatic);
[[nodiscard]] LineEstimate estimate_of(const StraightLineFamily& family, const TracingFourBar& linkage);

}  // namespace linkwright
