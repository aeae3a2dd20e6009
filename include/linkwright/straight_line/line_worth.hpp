#pragma once

#include <array>
#include <limits>

#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/measure.hpp"
#include "linkwright/straight_line/straight_path.hpp"

namespace linkwright {

/// What the path of a straight line is worth, measured or estimated: by this lines are asked for and ranked.
struct LineWorth {
  double usable = 0;                  ///< the length that counts, user's unit
  double deviation = 0;               ///< off the line over the stroke or, where none is asked for, over that length,
                                      ///< user's unit; infinite where the point does not go as far as the stroke, which
                                      ///< no requirement lets pass
  double min_transmission_angle = 0;  ///< over the same, radians; where the stroke is not reached over that length
  double velocity_nonuniformity = 0;  ///< over the same; infinite where the input turns back

  [[nodiscard]] static constexpr LineWorth unknown() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, nan};
  }
  /// `over`: the length that counts.
  [[nodiscard]] static LineWorth of(const StrokeFigures& over, double deviation);
};

/// What maps of straight lines hold, in this order.
inline constexpr std::array<Measure, 11> straight_line_measures = {measures::usable_stroke,
                                                                   measures::usable_strip,
                                                                   measures::deviation,
                                                                   measures::stroke_over_longest,
                                                                   measures::min_transmission_angle,
                                                                   measures::velocity_nonuniformity,
                                                                   measures::contact_coefficient,
                                                                   measures::usable_length,
                                                                   measures::link_ratio,
                                                                   measures::longest_link,
                                                                   measures::valid};
/// Those that follow from links and worth; NaN: usable_stroke, usable_strip, contact_coefficient.
[[nodiscard]] std::array<double, straight_line_measures.size()> measured_line(const TracingFourBar& linkage,
                                                                              const LineWorth& worth);

/// A linkage as a cell, without defects and place. `worth`: LineWorth::unknown() where its path is not known yet.
[[nodiscard]] Cell line_cell(const TracingFourBar& linkage, const LineWorth& worth);

}  // namespace linkwright
