#pragma once

#include <optional>
#include <string>

#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/motion_task.hpp"

namespace linkwright {

/// Same orientation modulo a whole turn.
[[nodiscard]] bool are_parallel(const Pose& a, const Pose& b);

/// Tasks whose dyads are no curve, or a curve without four-bars: a sentence that names the degeneracy and says what
/// does the task instead. Nothing for all others.
[[nodiscard]] std::optional<std::string> degeneracy_of(const MotionTask& task, const PoseConditions& conditions,
                                                       const BurmesterCurve& curve);

}  // namespace linkwright
