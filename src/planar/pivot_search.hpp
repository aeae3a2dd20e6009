#pragma once

#include <cstdint>

#include "linkwright/core/progress.hpp"
#include "linkwright/core/simd.hpp"
#include "linkwright/planar/path_task.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

struct PivotSearchOptions {
  Requirements requirements;  ///< lengths without a value are filled in
  Objective objective = Objective::min_transmission_angle;
  std::uint64_t seed = 1;  ///< the same seed finds the same place, whatever the threads
  int effort = 1;          ///< arms to be tried, ≥ 1
  int threads = 0;
  Simd simd = Simd::automatic;
};

/// What looking for a ground pivot showed.
struct PivotSearchResult {
  Point pivot{};                      ///< user's unit
  std::int64_t places = 0, arms = 0;  ///< tried
  std::int64_t meeting = 0;           ///< arms with a linkage that meets the requirements
  bool meets = false;                 ///< the best one's
};

/// A place for the input's ground pivot of a task that is_search() and has no mistakes: of some in its box, with some
/// arms each, the one with the best linkage, moved to where small random steps find nothing better. Not exact: other
/// places may have better ones. Where none meets the requirements it is one that comes close.
[[nodiscard]] PivotSearchResult search_for_pivot(const PathTask& task, const PivotSearchOptions& options,
                                                 const Progress& progress = {});

}  // namespace linkwright
