#pragma once

#include <optional>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// How the coupler and the output link are joined: sign of cross(input_moving − output_moving,
/// output_fixed − output_moving), the joint sign at the output's moving pivot, constant between dead points.
enum class Assembly : signed char { negative = -1, positive = +1 };
[[nodiscard]] inline Assembly opposite(Assembly assembly) {
  return assembly == Assembly::positive ? Assembly::negative : Assembly::positive;
}

/// Configuration of a four-bar in its own frame: input centre at 0, output centre at (ground, 0);
/// angles in radians from the frame's axis, of input_fixed→input_moving, input_moving→output_moving,
/// output_fixed→output_moving.
struct Configuration {
  double input_angle = 0, coupler_angle = 0, output_angle = 0;
};

/// Assembly in which a four-bar given by its pivots lies; positive at a dead point.
[[nodiscard]] Assembly assembly_of(const FourBar& four_bar);

/// Configuration in which a four-bar given by its pivots lies, angles in (−π, π]; a link without length counts as
/// lying along the axis.
[[nodiscard]] Configuration configuration_of(const FourBar& four_bar);

/// Forward kinematics, by the half angles of the triangle of coupler, output link and diagonal; the input angle is kept
/// as it is given, the others lie in (−π, π]. Nothing where the input cannot be at that angle, nor for links of no
/// positive finite length. Within tolerance::dead_point of a dead point it lies at the dead point. Where the moving
/// pivot of the input lies on the output's centre the output could be anywhere: one of its angles.
[[nodiscard]] std::optional<Configuration> assemble(const LinkLengths& lengths, double input_angle, Assembly assembly);

/// The four-bar whose frame lies as that of `reference`, at another configuration of the same lengths.
[[nodiscard]] FourBar placed(const FourBar& reference, const Configuration& configuration);

/// A closed range of input angles [from, to], radians, from ≤ to; a full turn has to − from = 2π.
struct AngleRange {
  double from = 0, to = 0;
  /// At least a whole turn.
  [[nodiscard]] bool is_full_turn() const;
};

/// Where the input can be, ascending: one full turn [−π, π], one range symmetric about 0 in [−π, π] or about π in
/// [0, 2π], or two ranges in [−π, π] (mirror images). Empty where the links cannot be assembled at all.
[[nodiscard]] std::vector<AngleRange> input_ranges(const LinkLengths& lengths);

/// Configuration in which coupler and output link lie in one line: the input can push no further.
struct DeadPoint {
  Configuration configuration;
  bool extended = false;  ///< the output pivots lie on opposite sides of the moving joint (|A − C_B| = h + b)
};

/// Dead points for a driven input, by ascending input angle in (−π, π]: the ends of its ranges; none where the input is
/// a crank, except at 0 or π in a change point, where it could leave the flat configuration in either assembly.
[[nodiscard]] std::vector<DeadPoint> dead_points(const LinkLengths& lengths);

/// First and second derivatives of the coupler and output angles by the input angle
/// (times the input's angular velocity, and its square, they are velocities and accelerations at constant drive).
struct AngleRates {
  double coupler = 0, output = 0;                            ///< dθ/dφ
  double coupler_acceleration = 0, output_acceleration = 0;  ///< d²θ/dφ²
};

/// Rates at a configuration in which the loop closes; nothing at a dead point (tolerance::dead_point_sine), where they
/// are unbounded.
[[nodiscard]] std::optional<AngleRates> angle_rates(const LinkLengths& lengths, const Configuration& configuration);

}  // namespace linkwright
