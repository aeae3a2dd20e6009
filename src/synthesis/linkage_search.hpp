#pragma once

#include <cstdint>
#include <vector>

#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

struct BestLinkages {
  std::vector<FourBarSolution> linkages;
  std::int64_t left_out = 0;  ///< is_unconfirmed
};

/// The best linkages of a solved region: its hill tops, climbed continuously in the two curve coordinates, then, while
/// there are fewer than wanted, the best of those that differ clearly from all before. Distinct, best first, each
/// analysed and driven through in user coordinates.
[[nodiscard]] BestLinkages best_linkages(const FourBarAnswer& answer, const RequirementFilter& filter,
                                         const Progress& progress);

}  // namespace linkwright
