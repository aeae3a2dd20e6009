#pragma once

#include <span>

#include "linkwright/analysis/defects.hpp"
#include "linkwright/analysis/driver_sequence.hpp"
#include "linkwright/mechanism/prescribed_orientation.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// In which senses a grounded link of a spherical linkage, turning as the driver about its fixed axis (right-handed:
/// counter-clockwise), meets the orientations in order within one turn. `orientations` in the order to be visited, the
/// moving axis as in the first; with `respect_direction`, one with an angular velocity is passed in its direction.
[[nodiscard]] DriverSequence driver_sequence(const SphericalDyad& dyad,
                                             std::span<const PrescribedOrientation> orientations,
                                             bool respect_direction);

/// Order, branch and circuit of one spherical four-bar, driven by its input, over one task, by the sign tests of
/// docs/theory/spherical.md: no trigonometry, no driving. `orientations`: distinct, one to five, the first being the
/// one in which `four_bar` is given.
[[nodiscard]] DefectReport find_defects(const SphericalFourBar& four_bar,
                                        std::span<const PrescribedOrientation> orientations,
                                        bool respect_direction = true);

}  // namespace linkwright
