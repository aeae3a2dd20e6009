#pragma once

#include <vector>

#include "approximate/curve_least_squares.hpp"

namespace linkwright {

/// Of the sine of a transmission angle below its limit.
inline constexpr double branch_weight = 3;

/// A row for each limit of the linkage as a whole that is broken, growing from 0 at the limit.
void append_linkage_hinges(const FitLimits& limits, const CouplerLinkage& linkage, std::vector<FitRow>& rows);

/// A row where a state comes too near to a dead point of the input, or is past it; nothing elsewhere. The input's dead
/// points are where cross(u, B − B0)/b vanishes, the sine of the transmission angle with a sign.
[[nodiscard]] std::optional<FitRow> branch_hinge(double min_sine, int branch, const CouplerLinkage& linkage,
                                                 const LoopState& at, Point target);

/// The sine of branch_hinge and its derivatives while the state slides to where its point is nearest to the target.
[[nodiscard]] FitRow transmission_sine_row(const CouplerLinkage& linkage, const LoopState& at, Point target);

}  // namespace linkwright
