#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/driver_sequence.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "linkwright/mechanism/pose.hpp"
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

/// T₁ = α₄ − α₁ + α₂ − α₃, T₂ = α₄ − α₁ − α₂ + α₃, T₃ = α₂ + α₃ − α₄ − α₁, T₄ = 2π − Σα of ground α₄, input α₁, coupler
/// α₂, output α₃: the input turns fully iff T₁T₂ > 0 and T₃T₄ > 0, the output iff T₁T₃ < 0 and T₂T₄ < 0, and some link
/// does iff T₁T₂T₃T₄ > 0. (A. P. Murray, P. M. Larochelle, "A classification scheme for planar 4R, spherical 4R, and
/// spatial RSSR linkages to facilitate computer animation", 1998.)
struct SphericalExcesses {
  double t1 = 0, t2 = 0, t3 = 0, t4 = 0;
};
/// Radians.
[[nodiscard]] SphericalExcesses spherical_excesses(const LinkAngles& angles);
/// The smallest excess, as a share of the four links together: how far they are from another type.
[[nodiscard]] double change_point_margin(const LinkAngles& angles);

/// crank_rocker, rocker_crank, double_crank, double_rocker or triple_rocker, which do not change when an axis is
/// replaced by its antipode; change point where an excess, degenerate where a link is at most tolerance::change_point
/// of the four links together (each or its supplement).
[[nodiscard]] LinkageType linkage_type(const LinkAngles& angles);

/// About what the links of a triple rocker swing, named by input and output: 0 along the arc between the fixed axes
/// (the output: along its continuation), π opposite to it. It changes when an axis is replaced by its antipode.
enum class TripleRockerKind : std::uint8_t { none, zero_zero, zero_pi, pi_zero, pi_pi };
[[nodiscard]] TripleRockerKind triple_rocker_kind(const LinkAngles& angles);
/// "none", "00", "0pi", "pi0", "pipi".
[[nodiscard]] std::string_view name(TripleRockerKind kind);

}  // namespace linkwright
