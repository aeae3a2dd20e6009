#pragma once

#include <cstddef>

namespace linkwright {

/// How far a path is from the target, user's unit. Distances are those of the points to the path.
struct CurveError {
  double sum_of_squares = 0;     ///< weighted
  double rms = 0;                ///< √(sum_of_squares / sum of weights)
  double max = 0;                ///< largest distance of a point of weight above 0
  std::size_t max_at = 0;        ///< index of that point
  double rms_over_diagonal = 0;  ///< a pure number
  double excursion = 0;          ///< largest distance of the path between the points from the polygon through them
  double path_length_ratio = 0;  ///< length of the path over that of the polygon
};

}  // namespace linkwright
