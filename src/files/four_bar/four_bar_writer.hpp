#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/json/json_writer.hpp"
#include "files/tolerance_writer.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/four_bar_solution.hpp"

namespace linkwright {

/// `[w, x, y]`.
void write_homogeneous(JsonWriter& json, Homogeneous point);

/// The members of a grounded link, in an object that is open.
void write_dyad_members(JsonWriter& json, const Dyad& dyad, double residual, const WorkingFrame& frame);

/// `{"distance": …, "angle_deg": …, "combined": …}`; `size` weighs the angle against the distance.
void write_pose_error(JsonWriter& json, const PoseError& error, double size);

/// What a file says of a four-bar beside the four-bar itself.
struct FourBarNotes {
  std::optional<Notice> defect;       ///< why the drive does not do the task
  std::vector<PrescribedPose> poses;  ///< of the coupler, where they are not the task's; otherwise none
  std::optional<double> free_value;   ///< of a function task's free parameter, as files hold it
  ListedNotes listed{};
  double pose_error_size = 1;  ///< what write_pose_error wants, where a pose is freed
};

/// The notes of a four-bar of a task's own map.
[[nodiscard]] FourBarNotes notes_on(const FourBarSolution& found, const TaskFamily& given);

/// An element of a result's `linkages`.
void write_four_bar(JsonWriter& json, const FourBarSolution& found, const WorkingFrame& frame,
                    const FourBarNotes& notes);

}  // namespace linkwright
