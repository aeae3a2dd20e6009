#pragma once

#include <vector>

#include "linkwright/function/generated_function.hpp"
#include "linkwright/function/wanted_function.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// The same bars with the senses of their moving axes chosen so that input and output link are at most 90°; the fixed
/// axes, about which angles are counted, keep theirs.
[[nodiscard]] SphericalFourBar with_short_side_links(SphericalFourBar bars);

/// Where the coupler of a spherical four-bar, given at the first pair, is at each pair, from where it is at the first.
/// Its input's moving axis is where the input has it; derivatives of all orders follow from those of the pairs as far
/// as the coupler keeps its angle, as it does for a solution. Passing through these is generating the pairs.
[[nodiscard]] std::vector<PrescribedOrientation> coupler_orientations(const SphericalFourBar& four_bar,
                                                                      const std::vector<AnglePair>& pairs);

/// Largest change of the coupler's angle over the pairs, radians.
[[nodiscard]] double coupler_residual(const SphericalFourBar& four_bar, const std::vector<AnglePair>& pairs);

/// What a spherical four-bar that stands at `first` generates, angles about its fixed axes.
[[nodiscard]] GeneratedFunction generated_function(const SphericalFourBar& four_bar, const AnglePair& first);

}  // namespace linkwright
