#pragma once

#include <cstdint>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/region/objective.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"

namespace linkwright {

/// How linkages are looked for that run straight over a stroke.
struct StraightLineSearchOptions {
  Objective objective = Objective::stroke;
  int best = 10;
  std::uint64_t seed = 1;  ///< of what is drawn
  double effort = 1;       ///< 1: a first list in some two seconds; the time grows with it
  int threads = 0;         ///< 0: as many as the machine has
};

/// What a search has found.
struct StraightLineSearchResult {
  /// Best first, each with the task on whose map it lies and its place there: scaled so that its strip is as long as
  /// the stroke, and moved so that the middle of both is on the line's point. `stroke` is what was wanted.
  std::vector<StraightLineSolution> linkages;
  std::int64_t drawn = 0;  ///< places of all maps that were looked at
  bool interrupted = false;

  [[nodiscard]] std::int64_t looked_at() const { return drawn; }
};

/// Looks over all cases, all layers and all that they leave open for linkages whose point runs straight over
/// `wanted.stroke`, its middle at the line's point, within ± `wanted.deviation`. Of each shape the smallest that does
/// it is taken: whether it is straight enough depends on its share of the stroke alone. First drawn at random and
/// estimated, then the best of each case and those of an atlas of long searches made better, then measured exactly.
/// `requirements` with max_length set.
[[nodiscard]] StraightLineSearchResult search_straight_lines(const DirectedLine& line,
                                                             const straight_cases::Search& wanted,
                                                             const Requirements& requirements,
                                                             const StraightLineSearchOptions& options,
                                                             const Progress& progress = {});

}  // namespace linkwright
