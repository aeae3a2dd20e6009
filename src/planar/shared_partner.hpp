#pragma once

#include <optional>

#include "linkwright/core/notice.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// Where two conditions are left and every circle point has the same centre, or the centre at the same distance from
/// it: common_pole {x, y} or translations_on_circle {x, y}, each with what does the task instead.
[[nodiscard]] std::optional<Notice> shared_partner(const PoseConditions& conditions);

/// All poses are parallel, on no common circle.
[[nodiscard]] Notice only_translations();

}  // namespace linkwright
