#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/region/linkage_class.hpp"

namespace linkwright {

/// One derivative of a point's path by any parameter that increases along the task (user's length, radians of the
/// crank, per power of the parameter).
struct PathDerivative {
  Point point{};
  /// Nothing: the parameter is the turn of the crank in the sense in which the task turns it; the first derivative of
  /// the crank's angle is then 1 or −1, all others are 0.
  std::optional<double> input;

  friend bool operator==(const PathDerivative&, const PathDerivative&) = default;
};

/// A place that a point of the coupler is to pass, and its first, second, … derivatives there. With m derivatives it
/// counts as m + 1 infinitesimally close positions.
struct PathPoint {
  Point point{};                ///< fixed frame, user's unit
  std::optional<double> input;  ///< angle of the crank there from any datum, radians, counter-clockwise
  std::vector<PathDerivative> derivatives;

  /// How many infinitesimally close positions it counts as, ≥ 1.
  [[nodiscard]] int multiplicity() const { return 1 + static_cast<int>(derivatives.size()); }

  friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

/// Ground pivots that a task gives, fixed frame, user's unit.
struct GroundPivots {
  std::optional<Point> input, output;

  [[nodiscard]] int count() const { return (input ? 1 : 0) + (output ? 1 : 0); }
  friend bool operator==(const GroundPivots&, const GroundPivots&) = default;
};

/// Path generation: a point of the coupler of a planar four-bar shall pass these places, in this order. Either the
/// crank is given at all of them: four or five positions, in any pattern from P-P-P-P to PPPPP. Or at none, and ground
/// pivots are: one with five positions, both with three.
struct PathTask {
  static constexpr const LinkageClass& linkages = path_linkages;
  static constexpr OutputKind output = OutputKind::point;

  std::vector<PathPoint> points;
  GroundPivots pivots;

  /// The crank is given at some point; without mistakes: at all.
  [[nodiscard]] bool is_timed() const {
    return std::any_of(points.begin(), points.end(), [](const PathPoint& point) { return point.input.has_value(); });
  }

  friend bool operator==(const PathTask&, const PathTask&) = default;
};

/// The caller's mistakes: number of positions, points without an angle of the crank, nothing that is given beside
/// points, numbers that are not finite or too large, a crank that stands or turns back at a derivative, equal angles,
/// angles that do not go one way within one turn, points at pivots, pivots at one place. Places are `task.points[i]…`
/// (i from 0) and `task.given.ground_pivots…`. Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const PathTask& task);

/// In which sense the crank of a timed task without mistakes turns: 1 counter-clockwise, −1 clockwise.
[[nodiscard]] double crank_sense(const PathTask& task);

/// A body that turns with the crank of a timed task without mistakes and is carried by its point: origin at the points,
/// angle of the crank from the first one on, with the derivatives of both. Every dyad of these poses is a crank of the
/// task (docs/theory/path.md).
[[nodiscard]] std::vector<PrescribedPose> crank_poses(const PathTask& task);

}  // namespace linkwright
