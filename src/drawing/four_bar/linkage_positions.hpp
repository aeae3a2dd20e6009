#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "linkwright/files/linkage_file.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// The four-bar, given as it lies in the first of the poses, as it lies in another one.
[[nodiscard]] FourBar in_pose(const FourBar& four_bar, std::span<const PrescribedPose> poses, std::size_t pose);

/// A linkage of a file by its positions, as it moves: where it comes nearest to each, and on another circuit as it
/// would be assembled there.
[[nodiscard]] std::vector<FourBar> in_positions(const StoredLinkage& linkage);

/// The traced point's way from the first pose to the last, driven as the task wants; empty where a defect forbids it
/// and of a single pose.
[[nodiscard]] std::vector<Point> path_of_task(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                              Point traced);

/// The traced point's way over the whole motion cycle.
[[nodiscard]] std::vector<Point> path_of_cycle(const FourBar& four_bar, Point traced);

}  // namespace linkwright
