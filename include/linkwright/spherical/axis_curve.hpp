#pragma once

#include <optional>
#include <vector>

#include "linkwright/algebra/cubic_cone.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/region/map_axis.hpp"
#include "linkwright/spherical/orientation_conditions.hpp"

namespace linkwright {

/// Longest side of a polygon on the unit sphere that looks smooth, radians.
inline constexpr double drawn_arc = 0.02;

/// All dyads that satisfy three conditions, in order: the cone of moving axes (circling-axis cone) with, to each of its
/// axes, the partner on the cone of fixed axes (centre-axis cone). A plane of that cone to a single moving axis, at
/// which the conditions leave a whole great circle of fixed axes, follows as a branch `fixed_circle`, so that every
/// dyad has a coordinate.
class AxisCurve {
 public:
  /// `conditions` has three rows or more; the first three count.
  explicit AxisCurve(OrientationConditions conditions);

  [[nodiscard]] CubicConeKind kind() const { return cone_.kind(); }
  [[nodiscard]] const CubicCone& cone() const { return cone_; }
  [[nodiscard]] const OrientationConditions& conditions() const { return conditions_; }
  /// By rising coordinate; none where every axis is a moving axis.
  [[nodiscard]] const std::vector<CurveBranch>& branches() const { return branches_; }
  /// A whole number of branches; 0 where every axis is a moving axis.
  [[nodiscard]] double coordinate_length() const { return branches().empty() ? 0 : branches().back().to; }

  /// The dyad at a coordinate (modulo coordinate_length()), unit vectors with an acute angle between them.
  [[nodiscard]] SphericalDyad dyad(double coordinate) const;
  /// Of a moving axis on (or near) the cone, there; nothing where every axis is one.
  [[nodiscard]] std::optional<double> coordinate_of(Vector3 moving_axis) const {
    return cone_.coordinate_of(moving_axis);
  }

  /// `count` coordinates: length·(i + ½)/count, or the same in the arc lengths run by both axes together.
  [[nodiscard]] std::vector<double> samples(int count, Spacing spacing) const;
  /// Dyads along all branches, by rising coordinate, each branch closed by its first dyad again (its coordinate just
  /// short of the branch's end), so dense that both axes together run at most `longest_side` (radians) from one to the
  /// next; within a branch an axis keeps its sense from one to the next.
  [[nodiscard]] std::vector<SphericalDyad> polygon(double longest_side = drawn_arc) const;

 private:
  // The fixed axes of one moving axis: all of a plane, cos · from + sin · to.
  struct FixedCircle {
    Vector3 moving, from, to;
  };

  void find_fixed_circles();
  [[nodiscard]] Vector3 beginning_of(Vector3 way, Vector3 moving) const;

  OrientationConditions conditions_;
  CubicCone cone_;
  std::vector<CurveBranch> branches_;
  std::vector<FixedCircle> fixed_circles_;
};

}  // namespace linkwright
