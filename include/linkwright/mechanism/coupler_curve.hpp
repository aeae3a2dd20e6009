#pragma once

#include <array>
#include <optional>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// One state of a driven four-bar, fixed frame of the four-bar it was made from; angles in radians.
struct MotionState {
  Configuration configuration;  ///< angles from the ground link's direction, without jumps from state to state
  FourBar four_bar;             ///< all four pivots
  Point coupler_point{};        ///< the traced point
  double transmission_angle = 0;
  std::optional<AngleRates> rates;  ///< nothing at a dead point
};

/// The motion cycle of `four_bar` on the circuit in which it lies, driven by its input, with the path of the coupler
/// point that lies at `traced` now; first and last state at the same place. A crank: `samples` states over one turn
/// from the present angle, counter-clockwise. Otherwise the whole closed circuit, 2·samples − 1 states: from the dead
/// point clockwise of the present angle in the present assembly to the other dead point, and back in the other
/// assembly, either way `samples` states evenly spaced in input angle. Cranks that pass a change point keep their
/// assembly. Empty for fewer than 2 samples, links that are none or cannot be assembled, a traced point that is not
/// finite.
[[nodiscard]] std::vector<MotionState> motion_cycle(const FourBar& four_bar, Point traced, int samples);

/// The states while the input turns from its present angle by `sweep` radians (negative: clockwise) without change
/// of assembly, or as far as a dead point on the way: `samples` of them, evenly spaced. Empty as in motion_cycle.
[[nodiscard]] std::vector<MotionState> motion_sweep(const FourBar& four_bar, Point traced, double sweep, int samples);

/// The two other four-bars whose point traces the same curve (Roberts' theorem, 1875), as they lie when the point is
/// where it is: the first on the input's centre, which turns as the coupler does, the second on the output's. Their
/// outputs share the third centre. Nothing where the coupler has no length or the point is at a moving pivot, to
/// tolerance::vanishing_link of the longest: its path is a circle.
[[nodiscard]] std::optional<std::array<TracingFourBar, 2>> cognates(const TracingFourBar& linkage);

}  // namespace linkwright
