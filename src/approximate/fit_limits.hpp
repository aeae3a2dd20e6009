#pragma once

#include <limits>
#include <optional>

#include "approximate/coupler_linkage.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// What linkages are held to, in the unit of the linkage; what is not asked for never binds.
struct FitLimits {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double max_length = unlimited, min_length = 0;  ///< of the four links
  double max_link_ratio = unlimited;              ///< longest over shortest
  double grashof_margin = -unlimited;  ///< least excess of the other two links over the shortest and the longest
  double min_sine = 0;                 ///< of the transmission angle at the points
  bool all_round = false;              ///< and of all others: the input turns fully
  std::optional<Box> ground;           ///< both fixed pivots
};

/// By how much the two other links exceed the shortest and the longest: positive of Grashof's linkages.
[[nodiscard]] inline double grashof_excess(const LinkLengths& l) {
  return l.perimeter() - 2 * (l.shortest() + l.longest());
}

/// The least sine of the transmission angle of an input that turns fully: in line with the frame, either way.
[[nodiscard]] inline double least_sine_all_round(const LinkLengths& l) {
  const auto sine_at = [&](double diagonal) {
    const double cosine =
        (l.coupler * l.coupler + l.output * l.output - diagonal * diagonal) / (2 * l.coupler * l.output);
    return std::sqrt(std::max(1 - cosine * cosine, 0.0));
  };
  return std::min(sine_at(l.ground - l.input), sine_at(l.ground + l.input));
}

}  // namespace linkwright
