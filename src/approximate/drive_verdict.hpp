#pragma once

#include <span>
#include <vector>

#include "approximate/coupler_circuit.hpp"
#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright {

/// Of a linkage whose input and output turn as these do.
[[nodiscard]] CurveDrive verdict(const CircuitDrive& drive, CurveDriver input, CurveDriver output);

/// By how much the input turns from the first state to each, radians: about what driving showed, since between sparse
/// states it may turn by more than half a turn; where they do not come in turn, by the shorter way from each to the
/// next.
[[nodiscard]] std::vector<double> input_turns(std::span<const LoopState> states, std::span<const double> on_the_way);

/// How far two targets may come in the wrong order along the way: their errors, given squared, move them along it as
/// they do across it, one forwards and the other back. Of many the largest stand for it, within what a few of them make
/// of it. `size`: of all targets; rounding, where targets are doubled, is a share of it.
[[nodiscard]] double order_noise(std::span<const double> squared_errors, double size);

}  // namespace linkwright
