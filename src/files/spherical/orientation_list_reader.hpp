#pragma once

#include <vector>

#include "files/json/json_object.hpp"
#include "linkwright/mechanism/prescribed_orientation.hpp"

namespace linkwright {

/// Whether members that nobody knows are mistakes.
enum class UnknownMembers { refused, ignored };

/// The member `orientations` of a task: each an orientation in one of five forms (`matrix`, `axis` with `angle_deg`,
/// `quaternion`, `rotation_vector`, `euler_deg` with `sequence`), beside it optionally `angular_velocity`,
/// `angular_acceleration`, `angular_jerk`, none of which may be skipped. Whether every one could be read.
[[nodiscard]] bool read_orientations(const JsonObject& task, Mistakes& mistakes, UnknownMembers others,
                                     std::vector<PrescribedOrientation>& orientations);

}  // namespace linkwright
