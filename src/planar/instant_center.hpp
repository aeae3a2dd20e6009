#pragma once

#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/three_pose_given.hpp"

namespace linkwright {

/// The poses, the first of them (finite) with the derivative that the instant centre sets: θ′ = 1 and d′ = i (d₁ − I);
/// with I at infinity θ′ = 0 and d′ normal to its direction, as large as the distance of the poses. Three poses become
/// a task of four positions, PP-P-P; in position 1 its grounded links lie on lines through I, since the velocity of a
/// moving pivot is normal to its grounded link and to its ray from I. Which way the body rotates is not known: use the
/// original poses where directions of travel count.
[[nodiscard]] std::vector<PrescribedPose> with_instant_center(std::vector<PrescribedPose> poses,
                                                              const InstantCenter& center);

}  // namespace linkwright
