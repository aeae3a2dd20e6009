#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/planar/motion_task.hpp"
#include "linkwright/planar/near_poses.hpp"

namespace linkwright {

/// The poses of a motion, to be compared with: where some are near, they and the exact ones as they are, with their
/// tolerances, weights and turning length; else all of them near, so that errors are told at each. Directions of travel
/// and what else the task gives do not count. Mistakes as of a motion past near poses: three different ones at least.
[[nodiscard]] Result<NearPoses> compared_poses(const MotionTask& task);
/// Poses alone; `turning_length`: user's unit, > 0; nothing: their characteristic length.
[[nodiscard]] Result<NearPoses> compared_poses(const std::vector<Pose>& poses,
                                               std::optional<double> turning_length = {});

/// How near a linkage carries its body to poses.
struct PoseComparison {
  NearMiss miss;                    ///< turns of the input are from where it is nearest to the first pose
  std::size_t position_max_at = 0;  ///< the near pose, from 0, farthest from which the body's origin is
  std::size_t angle_max_at = 0;     ///< the near pose from whose angle the body's differs most
  CurveDrive drive;                 ///< with its input as the driver
  PoseTarget target;
  FourBar bars;  ///< as they lie nearest to the first pose
};

/// On the circuit in which the linkage lies. `body`: where its body is as it lies, instead of the first of the file's
/// poses. A linkage that does not say where its body is, a body nowhere and a linkage that cannot be moved are
/// mistakes: `no_body`, `body_not_finite`, `linkage_stands`.
[[nodiscard]] Result<PoseComparison> compare_with_poses(const StoredLinkage& linkage, const std::optional<Pose>& body,
                                                        const NearPoses& poses);

/// A line to each pose: number, x, y and theta_deg, where the body is nearest, distance and angle between the two, and
/// the input's turn from the first pose in degrees; comma-separated, with a heading.
[[nodiscard]] std::string comparison_table(const PoseComparison& comparison);

}  // namespace linkwright
