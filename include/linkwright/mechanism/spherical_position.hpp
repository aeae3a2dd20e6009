#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/attitude/quaternion.hpp"
#include "linkwright/mechanism/drive_through.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/position.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// Configuration of a spherical four-bar in its own frame: input's fixed axis (0, 0, 1), output's (sin α₄, 0, cos α₄).
/// Angles in radians, right-handed about these: θ of the input's arc from the arc to the output's fixed axis, ψ of the
/// output's arc from the continuation of that arc. (C. H. Chiang, Kinematics of Spherical Mechanisms, 1988.)
struct SphericalConfiguration {
  double input_angle = 0, output_angle = 0;
};

/// How coupler and output link are joined: the sign of det [W₁ W₂ G₂], constant between dead points; positive at one.
[[nodiscard]] Assembly assembly_of(const SphericalFourBar& four_bar);

/// Configuration in which a four-bar given by its axes lies, angles in (−π, π].
[[nodiscard]] SphericalConfiguration configuration_of(const SphericalFourBar& four_bar);

/// Forward kinematics by the spherical triangle of coupler, output link and the diagonal from the input's moving to the
/// output's fixed axis, through half angles; the input angle is kept as it is given, the other lies in (−π, π].
/// Nothing where the input cannot be at that angle. A triangle flat within tolerance::dead_point is flat.
[[nodiscard]] std::optional<SphericalConfiguration> assemble(const LinkAngles& angles, double input_angle,
                                                             Assembly assembly);

/// The four-bar whose frame lies as that of `reference`, at another configuration of the same links.
[[nodiscard]] SphericalFourBar placed(const SphericalFourBar& reference, const SphericalConfiguration& configuration);

/// The turn that the coupler makes from one position of a four-bar to another.
[[nodiscard]] UnitQuaternion coupler_turn(const SphericalFourBar& from, const SphericalFourBar& to);

/// Where the input can be, ascending: as input_ranges() of planar ones.
[[nodiscard]] std::vector<AngleRange> input_ranges(const LinkAngles& angles);

/// Configuration in which coupler and output link lie in one great circle: the input can push no further.
struct SphericalDeadPoint {
  SphericalConfiguration configuration;
  bool extended = false;  ///< the output's axes lie on opposite sides of the moving joint
};
/// By ascending input angle in (−π, π]: the ends of the input's ranges.
[[nodiscard]] std::vector<SphericalDeadPoint> dead_points(const LinkAngles& angles);

/// Between coupler and output link at the output's moving axis, in [0, π/2], radians; exact near a dead point.
[[nodiscard]] double transmission_angle(const SphericalFourBar& four_bar);

/// dψ/dθ; nothing at a dead point of the input.
[[nodiscard]] std::optional<double> velocity_ratio(const SphericalFourBar& four_bar);

/// Drives the four-bar by its input through the orientations, slowly, as drive_through() of planar ones: traces the
/// circuit of configurations (θ, ψ) on which the coupler keeps its angle by arc-length continuation, and reads the
/// defects off; it shares nothing with find_defects(). `worst_pose_error` is the largest distance of a moving axis, on
/// the unit sphere, from where a visited orientation wants it.
[[nodiscard]] DriveThroughReport drive_through(const SphericalFourBar& four_bar,
                                               std::span<const PrescribedOrientation> orientations,
                                               const DriveThroughOptions& options = {});

}  // namespace linkwright
