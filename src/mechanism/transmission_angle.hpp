#pragma once

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/position.hpp"

namespace linkwright {

/// Transmission angle γ = min(μ, π − μ) in [0, π/2], μ the angle between coupler and output link at their joint
/// (H. Alt, "Der Übertragungswinkel", 1932); radians. 0 for links that are none.
[[nodiscard]] double transmission_angle(const LinkLengths& lengths, const Configuration& configuration);

/// Least transmission angle while the input turns from `from` to `to` (radians, either order): exact, from the extremes
/// of the diagonal. 0 where it would have to pass a dead point, or cannot be, on the way.
[[nodiscard]] double least_transmission_angle(const LinkLengths& lengths, double from, double to);

/// Least transmission angle over the full turn of a crank: the diagonal runs from |g − a| to g + a. 0 for other types.
[[nodiscard]] double least_transmission_angle_full_turn(const LinkLengths& lengths);

}  // namespace linkwright
