#pragma once

#include <optional>

#include "files/json/json_object.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// What is done with members of a pose that nobody knows.
enum class OtherMembers { refused, ignored };

/// `{"x": …, "y": …, "theta_deg": …, "derivatives": [{"x": …, "y": …, "theta": …}, …]}`, the derivatives optional and
/// at most four; nothing, with a mistake, where it is something else. How large the numbers are is not looked at.
[[nodiscard]] std::optional<PrescribedPose> read_pose(const JsonValue& value, Mistakes& mistakes, OtherMembers others);

}  // namespace linkwright
