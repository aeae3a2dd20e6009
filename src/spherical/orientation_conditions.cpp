#include "linkwright/spherical/orientation_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "algebra/binary_form.hpp"
#include "algebra/dense.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "spherical/minor_forms.hpp"

namespace linkwright {
namespace {

// Derivatives of a rotation matrix from those of its rotation, A⁽ᵐ⁾ = Σ (m−1 over k) [ω⁽ᵏ⁾]× A⁽ᵐ⁻¹⁻ᵏ⁾.
std::vector<Matrix3x3> rotation_derivatives(const Matrix3x3& a, const std::vector<Vector3>& derivatives) {
  std::vector<Matrix3x3> found = {a};
  for (std::size_t m = 1; m <= derivatives.size(); ++m) {
    Matrix3x3 sum{};
    for (std::size_t k = 0; k < m; ++k)
      sum = sum + binomial[m - 1][k] * (skew_matrix(derivatives[k]) * found[m - 1 - k]);
    found.push_back(sum);
  }
  found.erase(found.begin());
  return found;
}

Matrix3x3 of_unit_norm(const Matrix3x3& d) {
  const double length = frobenius_norm(d);
  return length > 0 ? (1 / length) * d : d;
}

// `pole`: the axis that the row leaves where it is, of any length; null: none known.
void add_row(OrientationConditions& conditions, const Matrix3x3& d, Vector3 pole) {
  conditions.rows.push_back(of_unit_norm(d));
  if (norm(pole) > 0) conditions.poles.push_back(normalized(pole));
}

void add_turn(OrientationConditions& conditions, const UnitQuaternion& turn) {
  add_row(conditions, turn.matrix_minus_identity(), turn.v());
  conditions.turns.push_back(turn);
}

void add_derivatives(OrientationConditions& conditions, const UnitQuaternion& turn,
                     const std::vector<Vector3>& derivatives) {
  if (derivatives.empty()) return;
  conditions.are_finite = false;
  Vector3 pole = turn.inverse().apply(derivatives.front());
  for (const Matrix3x3& d : rotation_derivatives(turn.matrix(), derivatives)) {
    add_row(conditions, d, pole);
    pole = {};
  }
}

CubicForm form_unless_rounding(const CubicForm& form, double noise) {
  return form.largest_coefficient() > tolerance::vanishing_cone * noise ? form : CubicForm{};
}

constexpr double nearly_one_axis = 1e-3;

// An axis that all rows leave where it is.
std::optional<Vector3> common_axis(const std::vector<Matrix3x3>& rows, double least) {
  const LeastImage axis = least_image(rows);
  return axis.length > least ? std::nullopt : std::optional(axis.vector);
}

}  // namespace

double OrientationConditions::condition() const {
  return singular.back() > 0 ? singular.front() / singular.back() : std::numeric_limits<double>::infinity();
}

OrientationConditions orientation_conditions(std::span<const PrescribedOrientation> orientations) {
  require(!orientations.empty(), "there is an orientation");
  const UnitQuaternion first = orientations.front().orientation;
  OrientationConditions conditions;
  conditions.are_finite = true;
  for (const PrescribedOrientation& there : orientations) {
    const UnitQuaternion turn = (there.orientation * first.inverse()).canonical();
    if (&there != &orientations.front()) add_turn(conditions, turn);
    add_derivatives(conditions, turn, there.derivatives);
  }
  conditions.singular = graded_singular_values(conditions.rows);
  return conditions;
}

OrientationConditions conditions_of_turns(std::span<const UnitQuaternion> turns) {
  OrientationConditions conditions;
  conditions.are_finite = true;
  for (const UnitQuaternion& turn : turns) add_turn(conditions, turn.canonical());
  conditions.singular = graded_singular_values(conditions.rows);
  return conditions;
}

OrientationConditions without_row(OrientationConditions conditions, std::size_t row) {
  const auto at = static_cast<std::ptrdiff_t>(row);
  conditions.rows.erase(conditions.rows.begin() + at);
  if (conditions.are_finite) conditions.turns.erase(conditions.turns.begin() + at);
  conditions.singular.clear();
  conditions.singular = graded_singular_values(conditions.rows);
  return conditions;
}

OrientationConditions inverted(OrientationConditions conditions) {
  for (Matrix3x3& row : conditions.rows) row = transposed(row);
  for (UnitQuaternion& turn : conditions.turns) turn = turn.inverse();
  conditions.poles.clear();
  return conditions;
}

CubicForm moving_axis_form(const OrientationConditions& conditions) {
  require(conditions.rows.size() >= 3, "a cone is left by three conditions");
  const CubicForm form = minor_form(parts_of(conditions, 0), parts_of(conditions, 1), parts_of(conditions, 2));
  if (!conditions.are_finite) return form_unless_rounding(form, 1);
  const auto& turns = conditions.turns;
  return form_unless_rounding(form, std::max({norm(turns[0].v()), norm(turns[1].v()), norm(turns[2].v())}));
}

Vector3 fixed_axis_of(Vector3 moving_axis, const OrientationConditions& conditions) {
  Vector3 best{}, steepest{};
  for (std::size_t i = 0; i < conditions.rows.size(); ++i) {
    const Vector3 a = conditions.rows[i] * moving_axis;
    if (norm(a) > norm(steepest)) steepest = a;
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3 normal = cross(a, conditions.rows[j] * moving_axis);
      if (norm(normal) > norm(best)) best = normal;
    }
  }
  if (norm(best) > 0) return normalized(best);
  // All say the same: any normal of it.
  const Vector3 across = norm(steepest) > 0 ? cross(steepest, moving_axis) : Vector3{};
  return norm(across) > 0 ? normalized(across) : moving_axis;
}

double residual_of(Vector3 fixed_axis, Vector3 moving_axis, const std::vector<Matrix3x3>& rows) {
  double worst = 0;
  for (const Matrix3x3& row : rows) worst = std::max(worst, std::abs(dot(fixed_axis, row * moving_axis)));
  return worst;
}

std::optional<Notice> orientation_degeneracy(std::span<const PrescribedOrientation> orientations,
                                             const OrientationConditions& conditions) {
  for (std::size_t j = 1; j < orientations.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (angle_between(orientations[i].orientation, orientations[j].orientation) <= tolerance::repeated_orientation)
        return Notice{
            "repeated_orientation",
            fmt::format(
                "Orientations {} and {} are the same (whole turns do not tell them apart), so that every axis "
                "of the body has a fixed axis: infinitely many linkages of each shape. Change one of them, give "
                "an angular velocity in its place, or leave it out and give two fixed or two moving axes.",
                i + 1, j + 1),
            {{"i", static_cast<double>(i + 1)}, {"j", static_cast<double>(j + 1)}}};
  const bool vanishes = conditions.rows.size() >= 3 && !(moving_axis_form(conditions).largest_coefficient() > 0);
  // Where nothing is left of the cone, turns about nearly one axis are what they can be told from no more.
  if (const auto axis = common_axis(conditions.rows, vanishes ? nearly_one_axis : tolerance::common_axis))
    return Notice{"common_axis",
                  fmt::format("The body only turns about one axis, ({:.6g}, {:.6g}, {:.6g}): a single hinge there does "
                              "the task. For a four-bar, tilt one of the orientations.",
                              axis->x, axis->y, axis->z),
                  {{"x", axis->x}, {"y", axis->y}, {"z", axis->z}}};
  if (!vanishes) return std::nullopt;
  return Notice{"every_axis",
                "The conditions of the orientations depend on each other: every axis of the body has a fixed axis, and "
                "infinitely many linkages of each shape do the task. Change one of the orientations.",
                {}};
}

}  // namespace linkwright
