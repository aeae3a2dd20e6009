#pragma once

#include <optional>

#include "linkwright/core/result.hpp"
#include "linkwright/function/function_error.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/fitted_path.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/near_poses.hpp"
#include "linkwright/planar/task_family.hpp"
#include "linkwright/planar/timed_path.hpp"

namespace linkwright {

/// A four-bar found, fixed frame, user's unit, checked in user coordinates.
struct FourBarSolution {
  Dyad input, output;  ///< fixed frame; circle points in position 1
  double input_residual = 0,
         output_residual = 0;  ///< worst relative change of the grounded link's length over the poses
  FourBar four_bar;
  LinkLengths lengths;
  DefectReport report;               ///< type, defects, drive sense, transmission angle, sweep
  DefectReport swapped;              ///< the same bars driven from the other side
  double residual = 0;               ///< the larger of the two grounded links' residuals
  bool local_optimum = false;        ///< refined to the top of its hill; otherwise a distinct linkage beside those
  bool verified_by_driving = false;  ///< drive_through confirms the defects, and the directions where they count

  /// Mixed positions: largest |Zᵀ M C| over derivative_conditions() and both grounded links, unit vectors of the
  /// working frame.
  std::optional<double> residual_derivatives;

  std::optional<PoseError> pose_error;    ///< of the pose that was freed
  std::optional<FunctionError> function;  ///< of function tasks
  std::optional<TimedPath> path;          ///< of path tasks
  std::optional<FittedPath> fit;          ///< of paths that pass near points
  std::optional<NearMiss> near;           ///< of motions past near poses
};

/// The four-bar at a place of a task's map, analysed, its residuals in user coordinates; with `verify`, driven through
/// as well. Nothing where the task has none there, a pivot is at infinity or a link has no length.
[[nodiscard]] std::optional<FourBarSolution> make_four_bar(const TaskFamily& given, MapPoint place,
                                                           bool respect_direction, bool verify);

/// Free of defects by the sign tests, and driving does not confirm it, or a grounded link that rounding keeps from
/// being one: so near a change point, a dead point or the common pole of the task, or with so short a link, that
/// rounding decides what the linkage does. Such a linkage is no answer.
[[nodiscard]] bool is_unconfirmed(const FourBarSolution& found);

/// Why a four-bar of the task's map does not do the task (mechanism/pose_visits.hpp); nothing without defects.
[[nodiscard]] std::optional<Notice> defect_notice(const FourBarSolution& found, const TaskFamily& given);

}  // namespace linkwright
