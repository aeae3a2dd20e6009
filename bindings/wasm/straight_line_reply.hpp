#pragma once

#include <optional>

#include "linkwright/straight_line/straight_line_solution.hpp"
#include "task_session.hpp"

namespace linkwright::wasm {

/// What the page is told of the linkage at a place, and its motion: over the usable length, or past the contacts at
/// places; the body is the coupler, its origin the point that runs straight.
[[nodiscard]] LinkageReply straight_line_reply(const StraightLineFamily& family,
                                               const std::optional<StraightLineSolution>& found, MapPoint place,
                                               FailureBits fails);

/// The path of a point of the coupler (as it lies in position 1) over that motion, x and y by turns.
[[nodiscard]] std::vector<double> straight_line_trace(const StraightLineFamily& family,
                                                      const StraightLineSolution& found, Point traced);

}  // namespace linkwright::wasm
