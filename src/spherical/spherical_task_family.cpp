#include "linkwright/spherical/spherical_task_family.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

std::vector<Notice> orientation_warnings(const OrientationConditions& conditions) {
  if (!(conditions.condition() > tolerance::ill_conditioned)) return {};
  return {
      {"ill_conditioned",
       fmt::format("The orientations are so close together that round-off dominates (condition number {:.1e}); give "
                   "them as rotation vectors or quaternions, not as matrices, or replace close ones by one with an "
                   "angular velocity.",
                   conditions.condition()),
       {{"condition", conditions.condition()}}}};
}

// The moving axis to a fixed one, by the transposed conditions.
Vector3 moving_axis_of(Vector3 fixed_axis, const OrientationConditions& conditions) {
  OrientationConditions transposed_rows;
  for (const Matrix3x3& row : conditions.rows) transposed_rows.rows.push_back(transposed(row));
  return fixed_axis_of(fixed_axis, transposed_rows);
}

SphericalDyad dyad_with(const GivenAxes& given, std::size_t side, const OrientationConditions& conditions) {
  const Vector3 axis = normalized(given.axes[side]);
  const bool fixed = given.kind == GivenAxes::Kind::fixed;
  SphericalDyad dyad{fixed ? axis : fixed_axis_of(axis, conditions), fixed ? moving_axis_of(axis, conditions) : axis,
                     static_cast<double>(side) + 0.5};
  if (dot(dyad.fixed_axis, dyad.moving_axis) < 0) {
    Vector3& found = fixed ? dyad.moving_axis : dyad.fixed_axis;
    found = -found;
  }
  return dyad;
}

std::shared_ptr<const SphericalFamily> family_of_points(const SphericalMotionTask& task,
                                                        const std::vector<SphericalDyadPoint>& points) {
  std::vector<SphericalDyad> dyads;
  for (const SphericalDyadPoint& point : points) dyads.push_back(point.dyad);
  return std::make_shared<SphericalPointFamily>(task.orientations, std::move(dyads));
}

void find_given(const SphericalMotionTask& task, SphericalTaskFamily& given) {
  for (const std::size_t side : {0u, 1u}) {
    SphericalDyadPoint point{dyad_with(*task.given, side, given.conditions)};
    point.residual = residual_of(point.dyad.fixed_axis, point.dyad.moving_axis, given.conditions.rows);
    given.points.push_back(point);
  }
  given.family = family_of_points(task, given.points);
}

void find_curve(const SphericalMotionTask& task, SphericalTaskFamily& given) {
  given.curve = std::make_shared<const AxisCurve>(given.conditions);
  given.family = std::make_shared<SphericalCurveFamily>(task.orientations, given.curve);
}

Notice too_few_dyads(std::size_t count) {
  if (count == 0)
    return {"no_dyad",
            "No real dyad, and so no four-bar, passes exactly through these five orientations. Relax one of them.",
            {}};
  return {"one_dyad",
          "Only one dyad passes exactly through these five orientations, and a four-bar needs two. Relax one of them.",
          {}};
}

// Any two of at most six dyads. Where two conditions say the same, what is left is a curve.
void find_points(const SphericalMotionTask& task, SphericalTaskFamily& given) {
  FiveOrientationDyads found = five_orientation_dyads(given.conditions);
  given.points = std::move(found.points);
  if (found.degeneracy && !found.curve) {
    given.degeneracy = std::move(found.degeneracy);
    return;
  }
  if (found.curve) {
    given.warnings.push_back(*found.degeneracy);
    given.curve = std::move(found.curve);
    given.family = std::make_shared<SphericalCurveFamily>(task.orientations, given.curve);
    return;
  }
  given.warnings.insert(given.warnings.end(), found.warnings.begin(), found.warnings.end());
  if (given.points.size() < 2) {
    given.degeneracy = too_few_dyads(given.points.size());
    given.has_no_dyads = true;
    return;
  }
  given.family = family_of_points(task, given.points);
}

}  // namespace

SphericalTaskFamily task_family(const SphericalMotionTask& task) {
  SphericalTaskFamily given;
  given.pattern = pattern(task.orientations);
  given.conditions = orientation_conditions(task.orientations);
  given.derivative_rows = derivative_rows(task.orientations, given.conditions);
  given.has_directions = !given.derivative_rows.empty();
  given.degeneracy = orientation_degeneracy(task.orientations, given.conditions);
  if (given.degeneracy) return given;
  given.warnings = orientation_warnings(given.conditions);
  if (task.given)
    find_given(task, given);
  else if (position_count(task.orientations) == 5)
    find_points(task, given);
  else
    find_curve(task, given);
  return given;
}

Requirements with_default_angles(Requirements wanted) {
  wanted.min_link_angle = wanted.min_link_angle.value_or(default_min_link_angle);
  return wanted;
}

}  // namespace linkwright
