#pragma once

#include <cstddef>

#include "linkwright/mechanism/spherical_analysis.hpp"
#include "linkwright/mechanism/travel.hpp"

namespace linkwright {

/// The motion of an analysis in the sense in which its orientations (as many as `positions`) come in order, or most
/// nearly so: from dead point to dead point, or a whole turn with the orientations in its middle. The dead points are
/// all that its driver meets.
[[nodiscard]] Travel travel_of(const SphericalAnalysis& analysis, std::size_t positions);

}  // namespace linkwright
