#pragma once

#include <random>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/motion_task.hpp"

namespace linkwright::testing {

/// Four poses of no particular kind: origins within a few units, angles within a turn.
[[nodiscard]] std::vector<PrescribedPose> random_poses(std::mt19937_64& random, int count = 4);

/// As many poses as there are multiplicities, with derivatives to match: numbers up to 2.
[[nodiscard]] std::vector<PrescribedPose> random_poses(std::mt19937_64& random, const std::vector<int>& multiplicities);

/// Four turns about one pole near (0.4, -0.7), the poses being off them by about `deviation` (length and radians).
[[nodiscard]] std::vector<PrescribedPose> nearly_common_pole(std::mt19937_64& random, double deviation);

/// Four poses that mirror each other in the y-axis but for about `deviation` (length and radians).
[[nodiscard]] std::vector<PrescribedPose> nearly_mirrored(std::mt19937_64& random, double deviation);

/// A task of finite poses.
[[nodiscard]] MotionTask motion_task(const std::vector<Pose>& poses);

/// The multiplicities of the seven mixed patterns of four positions: PP-P-P, P-PP-P, P-P-PP, PP-PP, PPP-P, P-PPP, PPPP.
[[nodiscard]] const std::vector<std::vector<int>>& mixed_patterns();

/// The same poses, directions included, after a rigid motion of the drawing and a change of scale about the origin.
[[nodiscard]] std::vector<PrescribedPose> moved(const std::vector<PrescribedPose>& poses, double scale, double angle,
                                                Point shift);

[[nodiscard]] double uniform(std::mt19937_64& random, double low, double high);

}  // namespace linkwright::testing
