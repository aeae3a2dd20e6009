#pragma once

#include <cstddef>

#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/solve.hpp"

// One linkage of a result file, solved anew at its place: what studies of it begin with.
namespace linkwright {

struct ListedPlace {
  Problem problem;  ///< asked at the linkage's place
  Answer answer;
  std::size_t place = 0;  ///< of the linkage in the answer, from 0
};

/// Of a problem asked at a place, the linkage of this layer.
[[nodiscard]] Result<ListedPlace> solved_place(Problem problem, int layer);

}  // namespace linkwright
