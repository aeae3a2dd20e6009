#pragma once

#include <fmt/format.h>
#include <string>

#include "linkwright/analysis/drive_extremes.hpp"
#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "text_table.hpp"

namespace linkwright::cli {

/// The transmission angle of a planar or spherical four-bar that was analysed: as it lies, and where it is least over a
/// crank's full turn (`least`, radians) or largest between dead points.
template <class Analysis>
[[nodiscard]] std::string transmission_words(const Analysis& analysis, double least) {
  std::string text =
      fmt::format("Transmission angle in the position given: {}", angle_text(analysis.transmission_angle));
  if (input_is_crank(analysis.type)) {
    text += fmt::format("; minimum over a full turn: {}", angle_text(least));
  } else if (!analysis.motion.empty()) {
    const TransmissionPeak& peak = analysis.largest_transmission;
    text += fmt::format("; it is 0 at the dead points and largest, {}, at input angle {}", angle_text(peak.angle),
                        angle_text(wrap_signed(peak.input_angle)));
  }
  return wrapped(text + ".");
}

}  // namespace linkwright::cli
