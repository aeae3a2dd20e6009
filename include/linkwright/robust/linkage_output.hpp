#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "linkwright/analysis/six_bar_position.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/robust/sensitivity.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

/// What is asked of a spherical four-bar, and how it lies in each position of its task. The first fixed axis and the
/// plane of the ground's arc stay where they are; the coupler is its first axis and the plane of its arc.
struct SphericalOutput {
  enum class Kind : unsigned char {
    orientation,  ///< the coupler's: rotation vector, radians
    angle         ///< the output's angle, radians
  };
  Kind kind = Kind::orientation;
  std::vector<SphericalFourBar> positions;  ///< of one linkage, the same arcs in all
};

/// The pose of a six-bar's guided body, and how the linkage lies in each position of its task. The driver's direction
/// is that from a to b; the guided frame lies fast to the direction from the guided body's first hinge to its second.
struct SixBarOutput {
  SixBar six_bar;
  std::vector<SixBarTurns> positions;  ///< closed to rounding
  Pose reference;                      ///< the guided frame in position 1
  double turning_length = 0;           ///< user's unit
};

using LinkageOutput = std::variant<PlanarOutput, SphericalOutput, SixBarOutput>;

[[nodiscard]] std::size_t positions_of(const LinkageOutput& output);
/// Straight lines, whose error is the largest over the stroke, not the mean over the positions.
[[nodiscard]] bool is_line(const LinkageOutput& output);

/// Its errors are angles, radians.
[[nodiscard]] bool is_angle(const LinkageOutput& output);

/// What of a linkage is made with a tolerance: a length, an arc, a coordinate, the driver's angle; user's unit,
/// radians.
struct MadeDimension {
  std::string name;      ///< as that of PlanarParameter; of a six-bar's length "length 2:b-d"
  double tolerance = 0;  ///< half
  int pins = 0;          ///< whose clearances lengthen or shorten it
  bool is_driver = false;
  bool is_angle = false;

  /// σ²: a pin lies anywhere in its clearance, evenly over the disc; along the link its variance is c²/4.
  [[nodiscard]] double variance(const Tolerances& tolerances) const;
  /// How far it can be off: the half tolerance, and the pins at their worst.
  [[nodiscard]] double reach(const Tolerances& tolerances) const { return tolerance + pins * tolerances.clearance; }
};
/// One to each column of sensitivities(); the point has no tolerance where an angle alone is asked for.
[[nodiscard]] std::vector<MadeDimension> made_dimensions(const LinkageOutput& output, const Tolerances& tolerances);

/// Nothing at a dead point.
[[nodiscard]] std::optional<SensitivityMatrix> sensitivities(const LinkageOutput& output);

}  // namespace linkwright
