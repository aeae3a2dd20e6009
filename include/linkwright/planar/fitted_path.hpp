#pragma once

#include <cstddef>
#include <vector>

#include "linkwright/approximate/curve_error.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// How near the path of a four-bar passes to the points of its task, user's unit.
struct FittedPath {
  /// Where the linkage is when its point is nearest to a point of the task, or its crank at the angle given there.
  struct Nearest {
    std::size_t point = 0;  ///< of the task, from 0
    double input = 0;       ///< turn of the input from position 1, radians
    Point place{};          ///< of the path
    double distance = 0;
  };

  bool timed = false;                 ///< distances are those at the angles of the crank that are given
  CurveError error;                   ///< its max_at is a point of the task, from 0
  std::vector<Nearest> at;            ///< in the order of the points
  std::vector<std::size_t> outside;   ///< points of the task, from 0, that are farther off than their tolerance
  std::vector<FourBar> realisations;  ///< the four-bars that trace the same path, this one first; position 1
  bool at_length_limit = false;       ///< longer links may come nearer
};

}  // namespace linkwright
