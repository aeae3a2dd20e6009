#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
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
  /// no_side_link_of_length {side, length, nearest}, no_side_link_at_angle, pivot_at_pole {side, pivot, x, y},
  /// pivot_of_slider {side, pivot, x, y}, pivots_of_one_link, no_dyad_on_lines, one_dyad_on_lines, lines_of_dyads.
  std::optional<Notice> degeneracy;
  bool chose_length = false;  ///< the one that was left open
};

/// `conditions`: of these three-position `poses` (user's frame). A length that is left open is chosen (chosen_length):
/// the one whose map has the best linkage under requirements and objective, of those that windows for pivots leave.
[[nodiscard]] ThreePoseSetup three_pose_setup(const PoseConditions& conditions,
                                              const std::vector<PrescribedPose>& poses, const SideLengths& given,
                                              const Requirements& requirements, Objective objective,
                                              const Progress& progress = {});
[[nodiscard]] ThreePoseSetup three_pose_setup(const PoseConditions& conditions,
                                              const std::vector<PrescribedPose>& poses, const SideAngle& given,
                                              const Requirements& requirements, Objective objective,
                                              const Progress& progress = {});

/// Given pivots have nothing to be chosen: one linkage, or a map over the place of the other link's pivot.
[[nodiscard]] ThreePoseSetup three_pose_setup(const PoseConditions& conditions,
                                              const std::vector<PrescribedPose>& poses, const GivenPivots& given);
/// One line: a map over the places of both links' pivots on it; two: the dyads between them, at most two.
[[nodiscard]] ThreePoseSetup three_pose_setup(const PoseConditions& conditions,
                                              const std::vector<PrescribedPose>& poses, const PivotLines& given);

}  // namespace linkwright
