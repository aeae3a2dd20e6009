#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/core/notice.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/planar/three_pose_given.hpp"
#include "linkwright/region/best_cells.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The family of a task of three positions with its additional constraint.
struct ThreePoseSetup {
  std::shared_ptr<const FourBarFamily> family;  ///< none where degenerate
  std::vector<Notice> notices;                  ///< chosen_length {side, length}, fixed_direction
  /// Why there is no family: common_pole {x, y}, translations_on_circle {x, y}, only_translations,
  /// no_side_link_of_length {side, length, nearest}, no_side_link_at_angle.
  std::optional<Notice> degeneracy;
};

/// `conditions`: of these three-position `poses` (user's frame). A length that is left open is chosen (chosen_length):
/// the one of 25 whose map, 100 × 100, has the best linkage under requirements and objective.
[[nodiscard]] ThreePoseSetup three_pose_setup(const PoseConditions& conditions,
                                              const std::vector<PrescribedPose>& poses, const SideLengths& given,
                                              const Requirements& requirements, Objective objective);
[[nodiscard]] ThreePoseSetup three_pose_setup(const PoseConditions& conditions,
                                              const std::vector<PrescribedPose>& poses, const SideAngle& given,
                                              const Requirements& requirements, Objective objective);

}  // namespace linkwright
