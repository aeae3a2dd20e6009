#pragma once

#include <optional>
#include <vector>

#include "files/json/json_object.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/body_points.hpp"

namespace linkwright {

/// What is done with members of a pose that nobody knows.
enum class OtherMembers { refused, ignored };

/// `{"x": …, "y": …, "theta_deg": …, "derivatives": [{"x": …, "y": …, "theta": …}, …]}`, the derivatives optional and
/// at most four; nothing, with a mistake, where it is something else. How large the numbers are is ignored.
[[nodiscard]] std::optional<PrescribedPose> read_pose(const JsonValue& value, Mistakes& mistakes, OtherMembers others);

/// The member `poses` of a task, each as read_pose() has it or all of them by two points of the body, `{"points":
/// [[x, y], [x, y]], "derivatives": …}`, which then are given, too; false where one of them cannot be read.
[[nodiscard]] bool read_poses(const JsonObject& task, Mistakes& mistakes, std::vector<PrescribedPose>& poses,
                              std::vector<BodyPoints>& points);

}  // namespace linkwright
