#pragma once

#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/three_pose_given.hpp"

namespace linkwright {

/// The poses, the first of them (finite) with the derivative that the instant centre sets: θ′ = 1 and d′ = i (d₁ − I);
/// with I at infinity θ′ = 0 and d′ across its direction, as large as the way between the poses. Three poses become a
/// task of four positions, PP-P-P; in position 1 its side links lie on lines through I, since a moving pivot travels
/// across its side link and across its ray from I. Which way the body turns is not known: take the poses as they were
/// where directions of travel count.
[[nodiscard]] std::vector<PrescribedPose> with_instant_center(std::vector<PrescribedPose> poses,
                                                              const InstantCenter& center);

}  // namespace linkwright
