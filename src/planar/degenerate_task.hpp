#pragma once

#include <optional>

#include "linkwright/core/result.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// Two conditions under which all circle points have one centre, or a centre that lies as far from each, and what does
/// the task instead: common_pole {x, y} or translations_on_circle {x, y}. Nothing where neither is so.
[[nodiscard]] std::optional<Notice> shared_center(const PoseConditions& conditions);

/// Why every point of the body is a circle point, and what does the task instead: common_pole {x, y},
/// translations_on_circle {x, y}, or every_point where no reason was found. `conditions` that depend on each other.
[[nodiscard]] Notice every_point_reason(const PoseConditions& conditions);

/// The same of parallel poses on no common circle: only_translations.
[[nodiscard]] Notice only_translations_reason();

}  // namespace linkwright
