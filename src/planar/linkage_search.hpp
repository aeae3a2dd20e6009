#pragma once

#include <vector>

#include "linkwright/planar/synthesis.hpp"

namespace linkwright {

/// The best linkages of a solved region: its hill tops, climbed continuously in the two curve coordinates, then, while
/// there are fewer than wanted, passing cells that differ clearly from all before. Distinct, best first, each analysed
/// and driven through in user coordinates.
[[nodiscard]] std::vector<FourBarSolution> best_linkages(const Solution& solution, const RequirementFilter& filter,
                                                         const Progress& progress);

}  // namespace linkwright
