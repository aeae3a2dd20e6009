#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/spherical/spherical_solution.hpp"

namespace linkwright {

/// How near the coupler of a driven four-bar comes to an orientation.
struct OrientationError {
  double angle = 0;  ///< of the turn that is missing there, radians
  double input = 0;  ///< the input angle there, of the four-bar's own frame
};
/// `four_bar` lies in `first`, and is driven from there without being taken apart. Nothing where the input does not get
/// near.
[[nodiscard]] std::optional<OrientationError> orientation_error(const SphericalFourBar& four_bar,
                                                                const UnitQuaternion& first,
                                                                const UnitQuaternion& wanted);

/// The alternative to a task of five positions when one of its orientations is relaxed.
struct RelaxedOrientation {
  std::size_t orientation = 0;  ///< which one, counted from 0
  /// The four-bar through the others that meets the requirements and comes nearest to it, in the first of the
  /// orientations that are left. Nothing: `reason` tells.
  std::optional<SphericalSolution> linkage;
  OrientationError error;
  std::int64_t meeting = 0;       ///< four-bars of the map that meet the requirements
  std::optional<MapPoint> place;  ///< of the linkage on the map of the task without the orientation
  std::optional<Notice> reason;   ///< degeneracy of the task that is left, none_left
};

/// For each orientation of a task of five positions that counts as one: the nearest that a usable four-bar through the
/// other four comes to it; nearest first, those without a linkage last. A least transmission angle of 20° is asked for
/// beyond the requirements wherever a linkage has it. `task` without mistakes. Cancelled: those that are done.
[[nodiscard]] std::vector<RelaxedOrientation> drop_one_orientation(const SphericalMotionTask& task,
                                                                   const Requirements& requirements,
                                                                   const RegionOptions& options = {},
                                                                   const Progress& progress = {});

}  // namespace linkwright
