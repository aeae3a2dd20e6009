#pragma once

#include <optional>
#include <span>

#include "approximate/curve_least_squares.hpp"

namespace linkwright {

/// A linkage that is given to begin with, in the frame of the fit, can be moved and is of a size to count with.
[[nodiscard]] bool is_usable_start(const FourBar& bars);

/// A linkage with its states, in turn on the circuit in which it lies, where it comes nearest to points; one frame.
/// Nothing where it cannot be moved.
[[nodiscard]] std::optional<CurveStart> start_in_turn(const CouplerLinkage& linkage, const LoopState& at,
                                                      std::span<const Point> points);

}  // namespace linkwright
