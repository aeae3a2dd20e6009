#pragma once

#include <array>
#include <functional>
#include <optional>

#include "linkwright/algebra/line_search.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/region/map_axis.hpp"

namespace linkwright {

/// How a map is climbed: what stands at each place of it, and over which stretch.
struct Hill {
  /// Score of the design at (first, second) coordinate, larger is better; nothing where there is none, or none that is
  /// allowed.
  std::function<std::optional<double>(double, double)> score_at;
  AxisStretch first, second;
};

struct HillClimbOptions {
  std::array<double, 2> first_step{};  ///< along each coordinate, the distance of two cells of the map; 0: stays
  double resolution = 1e-3;            ///< shares of the first steps to which the top is found
  int max_evaluations = 60;            ///< of each line search
  double across = 1e-3;                ///< shares of a step to which the best second coordinate is found each time
};

struct HillTop {
  std::array<double, 2> place{};  ///< on the stretches
  double score = 0;
  int evaluations = 0;
  SearchEnd end = SearchEnd::settled;  ///< evaluation_limit: it was still getting better, or was cancelled
};

/// The top of the hill on which a place with a score stands. A design is as good as the worst of several smooth
/// functions, so hills have sharp ridges on which steps in fixed directions get stuck: for each value of the first
/// coordinate the best value of the second is sought, and each of the two searches is on a line. Cancelled: the best so
/// far.
[[nodiscard]] HillTop climb_hill(const Hill& hill, std::array<double, 2> start, double score,
                                 const HillClimbOptions& options, const Progress& progress = {});

}  // namespace linkwright
