#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/spherical/five_orientations.hpp"
#include "linkwright/spherical/spherical_family.hpp"
#include "linkwright/spherical/spherical_motion_task.hpp"

namespace linkwright {

class SphericalFunctionFamily;

/// What is known of a task of spherical four-bars before any two dyads are paired: its conditions, and the family of
/// four-bars that meet them.
struct SphericalTaskFamily {
  std::string pattern;  ///< as pattern()
  OrientationConditions conditions;
  std::vector<Matrix3x3> derivative_rows;  ///< those of the conditions that derivatives set
  std::shared_ptr<const AxisCurve> curve;  ///< four positions; five whose conditions depend on each other
  std::vector<SphericalDyadPoint> points;  ///< three and five positions
  std::vector<Notice> warnings;
  std::optional<Notice> degeneracy;  ///< why there is no family
  bool has_directions = false;       ///< some orientation prescribes how it is passed
  bool has_no_dyads = false;         ///< because no two dyads do the task
  std::shared_ptr<const SphericalFamily> family;
  std::shared_ptr<const SphericalFunctionFamily> functions;  ///< of a function task: the family as what it is
};

/// `task` without mistakes (mistakes_in).
[[nodiscard]] SphericalTaskFamily task_family(const SphericalMotionTask& task);

/// The requirements with the default of min_link_angle filled in.
[[nodiscard]] Requirements with_default_angles(Requirements wanted);

}  // namespace linkwright
