#pragma once

#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// The problem of a result file, asked at the place of one of its linkages (SynthesisOptions::at): of those that were
/// searched for, the map that they are from.
struct ListedProblem {
  Problem problem;
  int layer = 0;  ///< of straight lines: which of the linkages at that place
};

/// `text`: of a result file; `linkage`: from 1. The caller's mistakes: none of that number, a linkage that stands at no
/// place of a map.
[[nodiscard]] Result<ListedProblem> read_listed_problem(std::string_view text, int linkage);

}  // namespace linkwright
