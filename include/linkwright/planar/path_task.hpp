#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// One derivative of a point's path by any parameter that increases along the task (user's length, radians, per power
/// of the parameter).
struct PathDerivative {
  Point point{};
  /// Of the crank's angle, where that is given. Nothing: the parameter is the turn of the crank in the sense in which
  /// the task turns it; the first derivative of the crank's angle is then 1 or −1, all others are 0.
  std::optional<double> input;
  std::optional<double> angle;  ///< of the coupler's, where that is given

  friend bool operator==(const PathDerivative&, const PathDerivative&) = default;
};

/// A place that a point of the coupler is to pass, and its first, second, … derivatives there. With m derivatives it
/// counts as m + 1 infinitesimally close positions.
struct PathPoint {
  Point point{};                ///< fixed frame, user's unit
  std::optional<double> input;  ///< angle of the crank there from any datum, radians, counter-clockwise
  std::optional<double> angle;  ///< or of the coupler, likewise
  std::vector<PathDerivative> derivatives;
  // Of paths that pass near points.
  std::optional<double> tolerance;  ///< how far from it the path may pass, user's unit, > 0
  std::optional<double> weight;     ///< of the squared distance, ≥ 0; nothing: 1

  /// How many infinitesimally close positions it counts as, ≥ 1.
  [[nodiscard]] int multiplicity() const { return 1 + static_cast<int>(derivatives.size()); }
  /// Neither angle is given.
  [[nodiscard]] bool is_plain() const { return !input && !angle; }

  friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

/// Ground pivots that a task gives, fixed frame, user's unit.
struct GroundPivots {
  std::optional<Point> input, output;

  [[nodiscard]] int count() const { return (input ? 1 : 0) + (output ? 1 : 0); }
  friend bool operator==(const GroundPivots&, const GroundPivots&) = default;
};

/// At how many of the points of a path the crank's angle is given.
enum class PathTiming { none, some, all };
/// "none", "some", "all".
[[nodiscard]] std::string_view name(PathTiming timing);

/// What becomes of a path between points that it is to pass near.
enum class PathBetween {
  free,
  polyline  ///< it keeps to the polygon through the points
};
/// "free", "polyline".
[[nodiscard]] std::string_view name(PathBetween between);

/// How the crank's angles at the points of a path that passes near them count.
enum class CrankTiming {
  free,      ///< not at all
  relative,  ///< as turns, from any datum and in either sense
  absolute   ///< as angles from the x axis, counter-clockwise
};
/// "free", "relative", "absolute".
[[nodiscard]] std::string_view name(CrankTiming timing);

/// What the map of paths that pass near points runs over.
enum class NearestMap {
  curves,  ///< those that were found
  pivots   ///< the places of the input's ground pivot, each with the nearest path from there
};
/// "curves", "pivots".
[[nodiscard]] std::string_view name(NearestMap map);

/// What a path task leaves open, and thereby what its map runs over.
enum class PathForm {
  cranks,         ///< four or five timed positions: pairs of cranks
  arms,           ///< five plain positions and a ground pivot, or three and both: all arms that reach them
  ground_pivot,   ///< three positions with angles and two plain ones: places of the input's ground pivot
  other_pivot,    ///< three timed positions and a ground pivot: places of the other one
  curve_of_arms,  ///< four positions with angles and a plain one: input links along their curve
  few,            ///< both ground pivots and five plain positions, or three timed ones: some linkages
  nearest,        ///< more plain positions than any four-bar passes, or near ones: the nearest curves
};

/// Path generation: a point of the coupler of a planar four-bar shall pass these places, in this order. Angles of the
/// crank or of the coupler are given at some, in place of them ground pivots. Or it shall pass as near to them as it
/// can.
struct PathTask {
  static constexpr std::size_t most_points = 1000;  ///< that a path may pass near
  static constexpr OutputKind output = OutputKind::point;

  std::vector<PathPoint> points;
  GroundPivots pivots;
  std::optional<Box> box;  ///< of five plain positions: where the input's ground pivot is searched for, user's unit
  // Of paths that pass near points; one of them, or a tolerance or a weight of a point, asks for these, and so do more
  // than five points without angles.
  bool closed = false;                 ///< from the last point on to the first, by an input that turns fully
  std::optional<double> tolerance;     ///< of all points without their own, user's unit, > 0
  std::optional<PathBetween> between;  ///< nothing: free
  std::optional<NearestMap> map;       ///< nothing: curves
  std::optional<CrankTiming>
      crank_timing;  ///< nothing: relative where all points have an angle of the crank, else free

  [[nodiscard]] const LinkageClass& linkage_class() const {
    return is_approximate() ? near_path_linkages : path_linkages;
  }
  /// The path is to pass near the points, not through them.
  [[nodiscard]] bool is_approximate() const;
  /// What only these have is given.
  [[nodiscard]] bool asks_for_nearest() const;
  /// Of a point; nothing: none is given.
  [[nodiscard]] std::optional<double> tolerance_at(std::size_t point) const;
  [[nodiscard]] PathTiming timing() const;
  /// The crank's angle is given at all points.
  [[nodiscard]] bool is_timed() const { return timing() == PathTiming::all; }
  /// Positions with an angle of the crank or of the coupler.
  [[nodiscard]] int angled_count() const;
  /// Of a task without mistakes, whose ground pivot has been found where it is searched for.
  [[nodiscard]] PathForm form() const;
  /// The input's ground pivot is searched for.
  [[nodiscard]] bool seeks_pivot() const { return box && pivots.count() == 0; }

  friend bool operator==(const PathTask&, const PathTask&) = default;
};

/// The caller's mistakes: number of positions, nothing that is given beside points, angles of both links, numbers that
/// are not finite or too large, a crank that stands or turns back at a derivative, equal angles, angles that do not go
/// one way within one turn, points at pivots, pivots at one place, a box that is empty or where nothing is searched
/// for; of paths near points anything given beside them, fewer than three different ones, tolerances and weights out of
/// range. Places are `task.points[i]…` (i from 0), `task.given.ground_pivots…`, `task.tolerance` and `options.box`.
/// Empty when the task can be solved.
[[nodiscard]] std::vector<Error> mistakes_in(const PathTask& task);

/// In which sense the crank of a task without mistakes turns that gives its angle somewhere: 1 counter-clockwise,
/// −1 clockwise.
[[nodiscard]] double crank_sense(const PathTask& task);

/// Where angles are given, the body that has them, carried by the task's point: origin at the points, with the
/// derivatives. The coupler; or a body that turns with the crank, its angle counted from the first of these points on
/// (docs/theory/path.md). Task without mistakes.
[[nodiscard]] std::vector<PrescribedPose> angled_poses(const PathTask& task);

}  // namespace linkwright
