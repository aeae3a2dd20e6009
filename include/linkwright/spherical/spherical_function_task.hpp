#pragma once

#include <array>
#include <vector>

#include "linkwright/algebra/vector3.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// Function generation by a spherical four-bar whose fixed axes are given: the input turns about the first,
/// (0, 0, 1), the output about the second, (sin α₄, 0, cos α₄), both right-handed, each from a datum of its own.
struct SphericalFunctionTask : WantedFunction {
  static constexpr const LinkageClass& linkages = spherical_linkages;
  static constexpr OutputKind output = OutputKind::angle;

  double ground_angle = 0;  ///< α₄ between the fixed axes, radians in (0, π)

  friend bool operator==(const SphericalFunctionTask&, const SphericalFunctionTask&) = default;
};

/// Input's and output's, unit vectors.
[[nodiscard]] std::array<Vector3, 2> fixed_axes(double ground_angle);

/// The caller's mistakes: those of the function, fixed axes that are one line (`task.ground_angle_deg`).
[[nodiscard]] std::vector<Error> mistakes_in(const SphericalFunctionTask& task);

/// As wanted_at().
[[nodiscard]] SphericalFunctionTask task_at(const SphericalFunctionTask& task, double value);

}  // namespace linkwright
