#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/robust/sensitivity.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

/// What of a linkage is made with a tolerance: a length, an arc, a coordinate, the driver's angle; user's unit,
/// radians.
struct MadeDimension {
  std::string name;      ///< as that of PlanarParameter; of a six-bar's length "length 2:b-d"
  double tolerance = 0;  ///< half
  int pins = 0;          ///< whose clearances lengthen or shorten it
  bool is_driver = false;
  bool is_angle = false;

  /// σ²: a pin lies anywhere in its clearance, evenly over the disc; along the link its variance is c²/4.
  [[nodiscard]] double variance(const Tolerances& tolerances) const;
  /// How far it can be off: the half tolerance, and the pins at their worst.
  [[nodiscard]] double reach(const Tolerances& tolerances) const { return tolerance + pins * tolerances.clearance; }
};
/// One to each column of sensitivities(); the point has no tolerance where an angle alone is asked for.
[[nodiscard]] std::vector<MadeDimension> made_dimensions(const LinkageOutput& output, const Tolerances& tolerances);

/// Nothing at a dead point.
[[nodiscard]] std::optional<SensitivityMatrix> sensitivities(const LinkageOutput& output);

}  // namespace linkwright
