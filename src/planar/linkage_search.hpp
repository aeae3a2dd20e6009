#pragma once

#include <vector>

#include "linkwright/planar/motion_synthesis.hpp"

namespace linkwright {

/// The best linkages of a solved region: its hill tops, climbed continuously in the two curve coordinates, then, while
/// there are fewer than wanted, passing cells that differ clearly from all before. Distinct, best first, each analysed
/// and driven through in user coordinates.
[[nodiscard]] std::vector<FourBarSolution> best_linkages(const MotionTask& task, const MotionSolution& solution,
                                                         const RequirementFilter& filter, const Progress& progress);

}  // namespace linkwright
