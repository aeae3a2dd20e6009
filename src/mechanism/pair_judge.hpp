#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "linkwright/algebra/point.hpp"
#include "linkwright/mechanism/defects.hpp"

namespace linkwright {

/// A grounded link in at most five positions of a task.
struct LinkInPositions {
  Point center{}, circle{};    ///< the moving pivot in the first position
  std::array<Point, 5> arm{};  ///< from the centre to the moving pivot
};

/// The verdict over a pair as maps hold it; lengths in the unit of the links.
struct PairJudgement {
  LinkageType type = LinkageType::degenerate;
  Defects defects;
  double versine = 0;       ///< 1 − cos of the least transmission angle over the travel; 0 with a defect
  double full_versine = 0;  ///< the same over the full turn of a crank; 0 for other types
  double ratio = 0, longest = 0;
};

/// As find_defects() judges. `senses`, `half_turn_senses`: of the input, as DriverSequence has them.
[[nodiscard]] PairJudgement judge_pair(const LinkInPositions& input, const LinkInPositions& output,
                                       std::size_t positions, std::uint8_t senses, std::uint8_t half_turn_senses);

}  // namespace linkwright
