#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/planar/burmester_curve.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

/// What is known of a four-position task before any two dyads are paired: its conditions and all dyads that meet them.
struct TaskCurve {
  std::string pattern;  ///< as pattern()
  PoseConditions conditions;
  std::shared_ptr<const BurmesterCurve> curve;
  std::vector<Notice> warnings;      ///< of pose_warnings(); none where degenerate
  std::optional<Notice> degeneracy;  ///< why the dyads are no curve of four-bars: common_pole {x, y},
                                     ///< translations_on_circle {x, y}, every_point, only_translations
};

/// ill_conditioned {condition} (of conditions that are independent), near_common_pole {x, y, miss}, parallel_poses
/// {poses}.
[[nodiscard]] std::vector<Notice> pose_warnings(const std::vector<PrescribedPose>& poses,
                                                const PoseConditions& conditions);

/// `task` without mistakes (mistakes_in), of four positions.
[[nodiscard]] TaskCurve task_curve(const MotionTask& task);

}  // namespace linkwright
