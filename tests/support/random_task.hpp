#pragma once

#include <random>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright::testing {

/// Four poses of no particular kind: origins within a few units, angles within a turn.
[[nodiscard]] std::vector<PrescribedPose> random_poses(std::mt19937_64& random, int count = 4);

/// The same poses after a rigid motion of the drawing and a change of scale about the origin.
[[nodiscard]] std::vector<PrescribedPose> moved(const std::vector<PrescribedPose>& poses, double scale, double angle,
                                                Point shift);

[[nodiscard]] double uniform(std::mt19937_64& random, double low, double high);

}  // namespace linkwright::testing
