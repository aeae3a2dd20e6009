#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose_error.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/burmester_points.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

class FunctionFamily;
class NearPoses;
class CellMeasure;
class PathFamily;

/// What is known of a task before any two dyads are paired: its conditions, and the family of four-bars that meet them.
struct TaskFamily {
  std::string pattern;  ///< as pattern()
  PoseConditions conditions;
  /// Of the derivatives alone (derivative_conditions), an instant centre among them.
  std::vector<HomogeneousMatrix> derivative_rows;
  std::shared_ptr<const BurmesterCurve> curve;  ///< four positions; otherwise none
  std::vector<BurmesterPoint> points;           ///< five positions, working frame
  std::vector<Notice> warnings;
  std::optional<Notice> degeneracy;             ///< why there is no family
  std::optional<RelaxedPose> relaxed;           ///< the pose of a five-position task that need not be passed, user's
                                                ///< frame
  bool has_directions = false;                  ///< some position prescribes how it is passed (derivatives)
  bool has_no_dyads = false;                    ///< because no two dyads do the task
  std::shared_ptr<const FourBarFamily> family;  ///< none where degenerate
  std::shared_ptr<const FunctionFamily> functions;  ///< of a function task: the family as what it is
  std::shared_ptr<const PathFamily> paths;          ///< of a path task: the same
  std::shared_ptr<const NearPoses> near;            ///< of a motion past near poses
  std::shared_ptr<const CellMeasure> near_error;    ///< likewise: of the family

  bool chose_length = false;  ///< of a grounded link, by maps of all lengths (chosen_length)
  /// The reference for long and short links, user's unit: the characteristic length, for functions the ground link.
  double size = 1;

  [[nodiscard]] const WorkingFrame& frame() const { return conditions.frame; }
  /// The position, from 1, in which linkages and their moving pivots are given: the first that is passed exactly.
  [[nodiscard]] int reference_position() const { return relaxed && relaxed->index == 0 ? 2 : 1; }
};

/// `task` without mistakes (mistakes_in). Requirements and objective choose what the task leaves to be chosen before
/// there is a map: the length of a grounded link among three positions, of which fewer are tried where that is
/// cancelled.
[[nodiscard]] TaskFamily task_family(const MotionTask& task, const Requirements& requirements, Objective objective,
                                     const Progress& progress = {});

/// The requirements with the defaults of both lengths filled in, by TaskFamily::size.
[[nodiscard]] Requirements with_defaults(Requirements wanted, const TaskFamily& given);

}  // namespace linkwright
