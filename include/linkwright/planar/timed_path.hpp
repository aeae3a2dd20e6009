#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// How a four-bar carries a point of its coupler through places as its crank, the input, turns; fixed frame, user's
/// unit.
struct TimedPath {
  Point point{};                ///< in position 1
  std::vector<double> input;    ///< turns of the crank from position 1 to the points, radians
  std::vector<double> coupler;  ///< turns of the coupler, radians in (−π, π]
  /// The other four-bar with the same path and timing, its input a crank that turns with this one; in position 1.
  /// Nothing where the task does not time the path.
  std::optional<FourBar> cognate;
  double cognate_size = 1;            ///< length of its crank over that of this one
  bool full_turn = false;             ///< the crank turns fully: the path is closed
  std::string elbows;                 ///< as PathFamily::elbows_at()
  std::optional<bool> circuit_order;  ///< along the circuit, either way round, the points come as they are listed;
                                      ///< nothing where they lie on different circuits
  // By driving (drive_along_path), where the crank got there.
  double position_error = 0;  ///< largest distance of the point from where it is to be, the crank standing as given
  double timing_error = 0;    ///< largest turn of the crank from there to where the point is nearest, radians
};

/// The coupler's poses of bars that lie in the first of the poses of a body which turns with their crank and is carried
/// by their point (crank_poses), in the same frame: origin at the point, angle 0 in position 1, with as many
/// derivatives (docs/theory/path.md).
[[nodiscard]] std::vector<PrescribedPose> path_poses(const FourBar& bars, std::span<const PrescribedPose> crank_poses);

/// The second of Roberts' cognates whose crank turns as that of `bars` does (S. Roberts, On three-bar motion in plane
/// space, 1875); `point` of the coupler, all as they lie. Pivots run to infinity where the point lies on the output's
/// moving pivot.
[[nodiscard]] FourBar timed_cognate(const FourBar& bars, Point point);

/// Whether the points come in their order, either way round, along the circuit of a four-bar's configurations; nothing
/// where they lie on different circuits. `poses`: of the coupler, at most five; the bars lie in the first.
[[nodiscard]] std::optional<bool> circuit_order(const FourBar& bars, std::span<const PrescribedPose> poses);

/// All of it but what driving says.
[[nodiscard]] TimedPath timed_path(const FourBar& bars, std::span<const PrescribedPose> crank_poses);

}  // namespace linkwright
