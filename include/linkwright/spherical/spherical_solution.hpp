#pragma once

#include <optional>

#include "linkwright/function/function_error.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/spherical/spherical_task_family.hpp"

namespace linkwright {

/// A spherical four-bar found, fixed frame, in position 1.
struct SphericalSolution {
  SphericalDyad input, output;  ///< senses as in `four_bar`
  SphericalFourBar four_bar;    ///< SphericalFamily::four_bar()
  LinkAngles angles;
  DefectReport report;   ///< type, defects, drive sense, transmission angle, sweep
  DefectReport swapped;  ///< the same bars driven from the other side
  double input_residual = 0,
         output_residual = 0;             ///< largest change of cos ∠(G, W) over the orientations
  double residual = 0;                    ///< the larger of the two
  bool local_optimum = false;             ///< refined to the top of its hill; otherwise a distinct linkage beside those
  bool verified_by_driving = false;       ///< drive_through confirms the defects, and the directions where they count
  std::optional<FunctionError> function;  ///< of a function task
  /// Mixed positions: largest |Gᵀ D W| over the conditions of the derivatives (unit rows) and both dyads.
  std::optional<double> residual_derivatives;
};

/// The four-bar at a place of a task's map, analysed; with `verify`, driven through as well. Nothing where the task has
/// none there or a link has no length.
[[nodiscard]] std::optional<SphericalSolution> make_spherical_four_bar(const SphericalTaskFamily& given, MapPoint place,
                                                                       bool respect_direction, bool verify);

/// Free of defects by the sign tests, and driving does not confirm it, or a dyad that rounding keeps from being one.
[[nodiscard]] bool is_unconfirmed(const SphericalSolution& found);

}  // namespace linkwright
