#pragma once

#include <span>
#include <vector>

#include "approximate/timed_least_squares.hpp"
#include "linkwright/core/simd.hpp"

namespace linkwright {

/// Ratios of the lengths of a four-bar to its input.
struct BarRatios {
  double ground, coupler, output;
};

/// The k-th of a sequence that fills the cube of their logarithms evenly, [1/9.5, 9.5] each (J. H. Halton, 1960).
[[nodiscard]] BarRatios bar_ratios(std::size_t k);
/// So many of the sequence; `full_turn`: whose input turns fully.
[[nodiscard]] std::vector<BarRatios> scanned_ratios(std::size_t count, bool full_turn);

/// A cell of the scan: a shape, the angle of its input from its ground link where a turn is 1, an assembly mode and a
/// sense.
struct TimedCell {
  BarRatios ratios{};
  double phase = 0;  ///< radians
  int branch = 1;
  bool reversed = false;
  double squares = 0;  ///< weighted, of weights of sum 1
};

/// For each of the shapes the cells that are better than those of neighbouring phases; the task's points are 24 at
/// most. `absolute`: the input's directions are prescribed.
[[nodiscard]] std::vector<TimedCell> scan_ratios(const TimedTask& task, bool absolute,
                                                 std::span<const BarRatios> shapes, Simd simd);

/// The linkage of a cell at the task's points, its states placed. Nothing where it does not reach.
[[nodiscard]] std::optional<TimedStart> timed_start(const TimedTask& task, bool absolute, const TimedCell& cell);

}  // namespace linkwright
