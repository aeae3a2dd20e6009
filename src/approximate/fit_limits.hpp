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
  std::optional<Box> ground;           ///< both fixed pivots
};

/// By how much the two other links exceed the shortest and the longest: positive of Grashof's linkages.
[[nodiscard]] inline double grashof_excess(const LinkLengths& l) {
  return l.perimeter() - 2 * (l.shortest() + l.longest());
}

}  // namespace linkwright
