#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// What is usable of a path: by the line itself, the tangent, or by a strip as wide that may lie anywhere beside it.
enum class LineMeasure { tangent, strip };
/// Key in files: "tangent", "strip".
[[nodiscard]] std::string_view name(LineMeasure measure);

/// How straight lines are measured.
struct LineMeasuring {
  static constexpr double default_share = 1e-4;
  static constexpr double least_share = 1e-13;  ///< below it is rounding what is measured

  std::optional<double> deviation;  ///< δ, half the width of the strip, user's unit; nothing: 1e-4 of the longest link;
                                    ///< at least 1e-13 of it
  std::optional<double> stroke;  ///< over which linkages are judged, half of it either way; nothing: none
  LineMeasure measure = LineMeasure::tangent;

  [[nodiscard]] double deviation_of(const TracingFourBar& linkage) const {
    const double longest = linkage.longest();
    return deviation ? std::max(*deviation, least_share * longest) : default_share * longest;
  }

  friend bool operator==(const LineMeasuring&, const LineMeasuring&) = default;
};

}  // namespace linkwright
