#include "linkwright/planar/task_family.hpp"

#include "linkwright/planar/task_curve.hpp"

namespace linkwright {
namespace {

// Four positions: both side links from one Burmester curve.
TaskFamily family_of_curve(const MotionTask& task) {
  TaskCurve found = task_curve(task);
  TaskFamily given;
  given.pattern = std::move(found.pattern);
  given.derivative_rows = derivative_conditions(task.poses, found.conditions.frame);
  given.conditions = std::move(found.conditions);
  given.curve = std::move(found.curve);
  given.warnings = std::move(found.warnings);
  given.degeneracy = std::move(found.degeneracy);
  if (!given.degeneracy) given.family = std::make_shared<CurveFamily>(given.frame(), task.poses, given.curve);
  return given;
}

}  // namespace

TaskFamily task_family(const MotionTask& task, const Requirements& /*requirements*/, Objective /*objective*/) {
  return family_of_curve(task);
}

Requirements with_defaults(Requirements wanted, const WorkingFrame& frame) {
  if (!wanted.max_length) wanted.max_length = default_max_length * frame.scale;
  return wanted;
}

}  // namespace linkwright
