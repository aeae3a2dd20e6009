#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "approximate/coupler_linkage.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// Share of a limit that rounding and hinges leave.
inline constexpr double limit_slack = 1e-6;

/// What linkages are held to, in the unit of the linkage; what is not asked for never binds.
struct FitLimits {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double max_length = unlimited, min_length = 0;  ///< of the four links
  double max_link_ratio = unlimited;              ///< longest over shortest
  double grashof_margin = -unlimited;  ///< least excess of the other two links over the shortest and the longest
  double min_sine = 0;                 ///< of the transmission angle at the points
  double min_turn_sine = 0;            ///< of the same over a full turn of the input
  std::optional<Box> ground;           ///< both fixed pivots
};

/// By how much the two other links exceed the shortest and the longest: positive of Grashof's linkages.
[[nodiscard]] inline double grashof_excess(const LinkLengths& l) {
  return l.perimeter() - 2 * (l.shortest() + l.longest());
}

/// Cosine of the angle of coupler and output where their far ends are so far apart, as when the input lies along the
/// ground link; beyond ±1 they do not reach.
[[nodiscard]] inline double closing_cosine(const LinkLengths& l, double apart) {
  return (l.coupler * l.coupler + l.output * l.output - apart * apart) / (2 * l.coupler * l.output);
}

/// Sine of the least transmission angle over a full turn of the input; 0 where there is none.
[[nodiscard]] inline double least_turn_sine(const LinkLengths& l) {
  const double largest = std::max(std::abs(closing_cosine(l, std::abs(l.ground - l.input))),
                                  std::abs(closing_cosine(l, l.ground + l.input)));
  return largest < 1 ? std::sqrt(1 - largest * largest) : 0;
}

}  // namespace linkwright
