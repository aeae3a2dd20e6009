#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// What a task asks of its linkages, and what errors are of: the pose of a body in the plane, the output's angle, a
/// body's turn about a centre, the distance of a point from a line, the place of a point.
enum class OutputKind : std::uint8_t { pose, angle, turn, line, point };

/// What is asked of a planar four-bar, and how it lies in each position of its task; errors are taken at the directions
/// that the input has there.
struct PlanarOutput {
  enum class Kind : unsigned char {
    pose,   ///< the point and the coupler's angle: x, y, turning_length · θ
    angle,  ///< the output's angle, radians
    line    ///< the point's distance to the left of a line
  };
  Kind kind = Kind::pose;
  std::vector<TracingFourBar> positions;  ///< of one linkage, the same links in all
  double turning_length = 0;              ///< of poses, user's unit
  DirectedLine line;                      ///< of lines
  /// Of lines: the line is turned and moved to lie best in each linkage made, by least squares over the positions (at
  /// least three); otherwise it stays where it was drawn.
  bool realigned = false;
  bool of_point = false;  ///< of poses: the point alone counts, and turning_length stays 0
  double body_angle = 0;  ///< of poses: of the moving frame in the first position, radians
  /// Of poses: of the body in each position, as the task prescribes them; none: nothing is prescribed.
  std::vector<std::vector<PoseDerivative>> derivatives{};
};
/// The poses of the body, of poses: its origin is the linkage's point.
[[nodiscard]] std::vector<PrescribedPose> poses_of(const PlanarOutput& output);
/// The body's origin is the linkage's point.
[[nodiscard]] PlanarOutput pose_output(std::vector<TracingFourBar> positions, double turning_length);
/// Of bars that lie in the first of the poses; turns count as no length.
[[nodiscard]] PlanarOutput pose_output(const FourBar& bars, std::span<const PrescribedPose> poses);
/// The same of the body's origin alone: its turns never count.
[[nodiscard]] PlanarOutput point_output(const FourBar& bars, std::span<const PrescribedPose> poses);
[[nodiscard]] PlanarOutput angle_output(std::span<const FourBar> positions);
[[nodiscard]] PlanarOutput angle_output(const FourBar& bars, std::span<const PrescribedPose> poses);
[[nodiscard]] PlanarOutput line_output(std::vector<TracingFourBar> stroke, const DirectedLine& line, bool realigned);

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

/// Of bars that lie in the first of the orientations.
[[nodiscard]] SphericalOutput spherical_output(SphericalOutput::Kind kind, const SphericalFourBar& bars,
                                               std::span<const PrescribedOrientation> orientations);

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

/// The same, turns of poses counted as lengths by `turning_length`, user's unit; of others as it is.
[[nodiscard]] LinkageOutput with_turning_length(LinkageOutput output, double turning_length);

}  // namespace linkwright
