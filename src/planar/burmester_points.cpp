#include "linkwright/planar/burmester_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "algebra/dense.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "planar/degenerate_task.hpp"
#include "planar/five_conditions.hpp"

namespace linkwright {
namespace {

ConditionRow row_of(const HomogeneousMatrix& m) {
  return {std::numbers::sqrt2 * m.row[1].x,
          std::numbers::sqrt2 * m.row[2].x,
          m.row[1].w,
          m.row[2].w,
          m.row[0].x,
          m.row[0].y,
          m.row[0].w};
}

ConditionRows rows_of(const PoseConditions& conditions) {
  return {row_of(conditions.rows[0]), row_of(conditions.rows[1]), row_of(conditions.rows[2]),
          row_of(conditions.rows[3])};
}

double residual_of(const PoseConditions& conditions, const Dyad& dyad) {
  double worst = 0;
  for (const HomogeneousMatrix& m : conditions.rows)
    worst = std::max(worst, std::abs(dot(dyad.circle, m * dyad.center)));
  return worst;
}

// Two unit vectors that with the given one make an orthonormal basis.
std::array<Homogeneous, 2> tangents_at(Homogeneous unit) {
  const double w = std::abs(unit.w), x = std::abs(unit.x), y = std::abs(unit.y);
  const Homogeneous axis = w <= x && w <= y ? Homogeneous{1, 0, 0}
                           : x <= y         ? Homogeneous{0, 1, 0}
                                            : Homogeneous{0, 0, 1};
  const Homogeneous first = normalized(cross(unit, axis));
  return {first, cross(unit, first)};
}

/// The four conditions about a dyad, linear in steps of its unit vectors along two tangents each.
struct Linearized {
  std::array<Homogeneous, 2> of_circle, of_center;
  DenseMatrix<4, 4> slope;
  std::array<double, 4> value;

  Linearized(const PoseConditions& conditions, const Dyad& dyad)
      : of_circle(tangents_at(dyad.circle)), of_center(tangents_at(dyad.center)) {
    for (std::size_t k = 0; k < 4; ++k) {
      const HomogeneousMatrix& m = conditions.rows[k];
      const Homogeneous mc = m * dyad.center, zm = dyad.circle * m;
      value[k] = dot(dyad.circle, mc);
      slope[k] = {dot(of_circle[0], mc), dot(of_circle[1], mc), dot(zm, of_center[0]), dot(zm, of_center[1])};
    }
  }
  [[nodiscard]] Dyad corrected(const Dyad& dyad) const {
    const auto step = solve(slope, value);
    return {normalized(dyad.center - step[2] * of_center[0] - step[3] * of_center[1]),
            normalized(dyad.circle - step[0] * of_circle[0] - step[1] * of_circle[1]), dyad.coordinate};
  }
};

// Newton on the conditions themselves for as long as it helps.
Dyad polished(const PoseConditions& conditions, Dyad dyad) {
  constexpr int max_steps = 4;
  double residual = residual_of(conditions, dyad);
  for (int step = 0; step < max_steps; ++step) {
    const Dyad next = Linearized(conditions, dyad).corrected(dyad);
    const double then = residual_of(conditions, next);
    if (!(then < residual)) break;
    dyad = next;
    residual = then;
  }
  return dyad;
}

double condition_of(const PoseConditions& conditions, const Dyad& dyad) {
  constexpr double most = 1 / std::numeric_limits<double>::epsilon();
  const double least = singular_values(Linearized(conditions, dyad).slope).values.back();
  return std::min(conditions.condition() / std::max(least, 1 / most), most);
}

// w ≥ 0; at infinity x ≥ 0: the same point has the same vector.
Homogeneous with_sign(Homogeneous v) {
  const double sign = v.w != 0 ? v.w : v.x != 0 ? v.x : v.y;
  return sign < 0 ? -1.0 * v : v;
}

BurmesterPoint point_of(const PoseConditions& conditions, const DyadSpace& space,
                        const ConicIntersection::Place& place) {
  Dyad dyad = factors_of(space, place.point);
  if (place.multiplicity == 1) dyad = polished(conditions, dyad);
  dyad.circle = with_sign(dyad.circle);
  dyad.center = with_sign(dyad.center);
  return {dyad, place.multiplicity, residual_of(conditions, dyad), condition_of(conditions, dyad)};
}

// Fewer than four conditions are independent: what is left.
void explain_dependence(const PoseConditions& conditions, BurmesterPoints& result) {
  PoseConditions independent = conditions;
  independent.rows.resize(3);
  independent.singular_values.resize(3);
  auto curve = std::make_shared<const BurmesterCurve>(independent);
  if (curve->kind() == CubicKind::every_point) {
    result.degeneracy = every_point_reason(independent);
  } else if (conditions.only_translations) {
    result.degeneracy = only_translations_reason();
  } else {
    const std::string kind(name(curve->kind()));
    result.degeneracy = {"dependent_rows",
                         fmt::format("The conditions of the five positions depend on each other: {} are independent, "
                                     "and a whole curve of dyads ({}) satisfies all five. Solve them as a "
                                     "task of four positions, or move one.",
                                     conditions.rank, kind),
                         {{"rank", static_cast<double>(conditions.rank)}, {"curve", kind}}};
    result.curve = std::move(curve);
  }
}

Notice common_component() {
  return {"common_component",
          "The five positions are satisfied by more than isolated dyads: a whole curve of dyads passes through all "
          "five. Drop one position and solve the other four, or move one.",
          {}};
}

Notice double_side_link(std::size_t index, int multiplicity) {
  return {"double_point",
          fmt::format("Dyad {} is a solution of multiplicity {}: a small change of a pose moves it far, splits "
                      "it, or makes it vanish.",
                      index + 1, multiplicity),
          {{"point", static_cast<double>(index + 1)}, {"multiplicity", static_cast<double>(multiplicity)}}};
}

}  // namespace

BurmesterPoints burmester_points(const PoseConditions& conditions) {
  require(conditions.rows.size() == 4, "Burmester points are those of five positions");
  BurmesterPoints result;
  if (conditions.rank < 4) {
    explain_dependence(conditions, result);
    return result;
  }
  const DyadSpace space = dyad_space(rows_of(conditions));
  const ConicIntersection intersection = dyads_in(space);
  result.complex_roots = intersection.complex_points;
  if (intersection.common_component) result.degeneracy = common_component();
  for (int i = 0; i < intersection.count; ++i)
    result.points.push_back(point_of(conditions, space, intersection.places[static_cast<std::size_t>(i)]));
  std::sort(result.points.begin(), result.points.end(),
            [](const BurmesterPoint& a, const BurmesterPoint& b) { return comes_before(a.dyad, b.dyad); });
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    result.points[i].dyad.coordinate = static_cast<double>(i) + 0.5;
    if (result.points[i].multiplicity > 1)
      result.warnings.push_back(double_side_link(i, result.points[i].multiplicity));
  }
  return result;
}

}  // namespace linkwright
