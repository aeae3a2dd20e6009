#pragma once

#include <optional>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/listed_notes.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/four_bar_solution.hpp"

namespace linkwright {

/// `[w, x, y]`.
void visit_homogeneous(FieldVisitor& v, Homogeneous point);

/// A grounded link. Points are at infinity by the measure of the frame.
struct DyadRecord {
  Dyad dyad;
  double residual;
  const WorkingFrame& frame;
};
void fields(FieldVisitor& v, const DyadRecord& of);
/// The same with its multiplicity and condition.
struct BurmesterPointRecord {
  const BurmesterPoint& point;  ///< in the working frame
  const WorkingFrame& frame;
};
void fields(FieldVisitor& v, const BurmesterPointRecord& of);

/// How far a pose is missed; `size` weighs the angle against the distance.
struct MissRecord {
  PoseError error;
  double size;
};
void fields(FieldVisitor& v, const MissRecord& of);

/// What a file says of a four-bar beside the four-bar itself.
struct FourBarNotes {
  std::optional<Notice> defect;       ///< why the drive does not do the task
  std::vector<PrescribedPose> poses;  ///< of the coupler, where they are not the task's; otherwise none
  std::optional<double> free_value;   ///< of a function task's free parameter, as files hold it
  ListedNotes listed{};
  double pose_error_size = 1;  ///< MissRecord::size, where a pose is freed
};

/// The notes of a four-bar of a task's own map.
[[nodiscard]] FourBarNotes notes_on(const FourBarSolution& found, const TaskFamily& given);

/// An element of a result's `linkages`.
struct FourBarRecord {
  const FourBarSolution& found;
  const WorkingFrame& frame;
  FourBarNotes notes;
};
void fields(FieldVisitor& v, const FourBarRecord& of);

}  // namespace linkwright
