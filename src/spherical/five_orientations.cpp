#include "linkwright/spherical/five_orientations.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "algebra/dense.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"
#include "spherical/common_lines.hpp"
#include "spherical/dyad_order.hpp"
#include "spherical/minor_forms.hpp"

namespace linkwright {
namespace {

// Two unit vectors that with the given one make an orthonormal basis (T. Duff et al., Building an Orthonormal Basis,
// Revisited, 2017).
std::array<Vector3, 2> tangents_at(Vector3 unit) {
  const double sign = std::copysign(1.0, unit.z), part = -1 / (sign + unit.z), mixed = unit.x * unit.y * part;
  return {Vector3{1 + sign * unit.x * unit.x * part, sign * mixed, -sign * unit.x},
          Vector3{mixed, sign + unit.y * unit.y * part, -unit.y}};
}

using Step = std::array<double, 4>;  ///< along both tangents of the fixed axis, then of the moving one

Step operator-(const Step& step) { return {-step[0], -step[1], -step[2], -step[3]}; }
double dot(const Step& a, const Step& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }
Step column(const DenseMatrix<4, 4>& a, std::size_t j) { return {a[0][j], a[1][j], a[2][j], a[3][j]}; }

/// The four conditions about a dyad, bilinear in steps of its unit vectors along two tangents each.
struct ConditionSteps {
  SphericalDyad dyad;
  std::array<Vector3, 2> of_fixed, of_moving;
  DenseMatrix<4, 4> slope;
  std::array<double, 4> value;

  ConditionSteps(const OrientationConditions& conditions, const SphericalDyad& at)
      : dyad(at), of_fixed(tangents_at(at.fixed_axis)), of_moving(tangents_at(at.moving_axis)) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Matrix3x3& d = conditions.rows[k];
      const Vector3 dw = d * dyad.moving_axis, gd = dyad.fixed_axis * d;
      value[k] = dot(dyad.fixed_axis, dw);
      slope[k] = {dot(of_fixed[0], dw), dot(of_fixed[1], dw), dot(gd, of_moving[0]), dot(gd, of_moving[1])};
    }
  }
  [[nodiscard]] double residual() const {
    return std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2]), std::abs(value[3])});
  }
  [[nodiscard]] Vector3 fixed_step(const Step& step) const { return step[0] * of_fixed[0] + step[1] * of_fixed[1]; }
  [[nodiscard]] Vector3 moving_step(const Step& step) const { return step[2] * of_moving[0] + step[3] * of_moving[1]; }
  [[nodiscard]] SphericalDyad dyad_after(const Step& step) const {
    return {normalized(dyad.fixed_axis + fixed_step(step)), normalized(dyad.moving_axis + moving_step(step)), 0};
  }
  /// What a step adds to the conditions beside the slope: nothing but this.
  [[nodiscard]] std::array<double, 4> second_order(const OrientationConditions& conditions, const Step& step) const {
    std::array<double, 4> found;
    for (std::size_t k = 0; k < 4; ++k) found[k] = dot(fixed_step(step), conditions.rows[k] * moving_step(step));
    return found;
  }
};

// Newton on the conditions themselves for as long as it helps.
SphericalDyad polished(const OrientationConditions& conditions, const SphericalDyad& dyad) {
  constexpr int max_steps = 6;
  ConditionSteps at(conditions, dyad);
  for (int step = 0; step < max_steps; ++step) {
    const ConditionSteps next(conditions, at.dyad_after(solve(at.slope, -at.value)));
    if (!(next.residual() < at.residual())) break;
    at = next;
  }
  return at.dyad;
}

// The norm of the inverse of the slope, whose largest singular value is well conditioned.
double condition_of(const ConditionSteps& at) {
  constexpr double most = 1 / std::numeric_limits<double>::epsilon();
  return std::min(norm_of_inverse(at.slope), most);
}

/// Dyads found by one pencil.
struct FoundDyads {
  std::array<SphericalDyad, 6> dyads{};
  std::array<int, 6> multiplicity{};
  std::size_t count = 0;
  int complex_roots = 0;
  double doubt = 0;  ///< how far a dyad moved when it was polished; 1 where two became one

  void add(const SphericalDyad& dyad, int times) {
    dyads[count] = dyad;
    multiplicity[count++] = times;
  }
};

double apart(const SphericalDyad& a, const SphericalDyad& b) {
  return norm(cross(a.moving_axis, b.moving_axis)) + norm(cross(a.fixed_axis, b.fixed_axis));
}

void add_single(const OrientationConditions& conditions, Vector3 moving, FoundDyads& found) {
  const SphericalDyad dyad = polished(conditions, {fixed_axis_of(moving, conditions), moving, 0});
  found.doubt = std::max(found.doubt, norm(cross(dyad.moving_axis, moving)));
  for (std::size_t i = 0; i < found.count; ++i)
    if (apart(found.dyads[i], dyad) < tolerance::double_point) found.doubt = 1;
  found.add(dyad, 1);
}

// Two dyads that nearly coincide: beside the direction e in which the conditions hardly change, they are met by Newton
// steps; along it they are φ + σ t + κ t² = 0, whose roots, real, complex or as good as one, the two are.
void add_pair(const OrientationConditions& conditions, Vector3 moving, FoundDyads& found) {
  constexpr double far = 1e2 * tolerance::nearly_double_line;
  ConditionSteps at(conditions, {fixed_axis_of(moving, conditions), moving, 0});
  auto svd = singular_values(at.slope);
  for (int turn = 0; turn < 3; ++turn) {
    Step step{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double size = -dot(column(svd.left, k), at.value) / svd.values[k];
      for (std::size_t i = 0; i < 4; ++i) step[i] += size * svd.right[i][k];
    }
    if (!std::all_of(step.begin(), step.end(), [](double part) { return std::isfinite(part); })) break;
    at = ConditionSteps(conditions, at.dyad_after(step));
    svd = singular_values(at.slope);
  }
  const Step along = column(svd.right, 3), across = column(svd.left, 3);
  const double value = dot(across, at.value), slope = svd.values[3];
  const double bend = dot(across, at.second_order(conditions, along));
  const double middle = -0.5 * slope / bend, square = middle * middle - value / bend;
  const double half = std::sqrt(std::abs(square));
  const auto at_step = [&](double t) {
    return at.dyad_after({t * along[0], t * along[1], t * along[2], t * along[3]});
  };
  if (!(std::abs(middle) + half < far)) {
    found.add(at.dyad, 2);
  } else if (2 * half < tolerance::double_point) {
    found.add(at_step(middle), 2);
  } else if (square < 0) {
    found.complex_roots += 2;
  } else {
    for (const double t : {middle - half, middle + half}) found.add(polished(conditions, at_step(t)), 1);
  }
}

// The rows turned in their space so that the first is symmetric: four skew parts are one too many for space. The turn
// costs nothing, and small orientations keep what makes their conditions different.
std::array<ConditionParts, 4> one_of_them_symmetric(const OrientationConditions& conditions) {
  std::array<ConditionParts, 4> parts;
  DenseMatrix<4, 3> skew;
  for (std::size_t k = 0; k < 4; ++k) {
    parts[k] = parts_of(conditions, k);
    skew[k] = {parts[k].skew.x, parts[k].skew.y, parts[k].skew.z};
  }
  const DenseMatrix<4, 4> turn = completed_basis(skew);
  std::array<ConditionParts, 4> turned;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) turned[i] = turned[i] + turn[k][i] * parts[k];
    if (i == 3) turned[i].skew = {};
    const double size = frobenius_norm(turned[i].matrix());
    if (size > 0) turned[i] = (1 / size) * turned[i];
  }
  return turned;
}

std::optional<FoundDyads> dyads_by(int pencil, const OrientationConditions& conditions,
                                   const std::array<CubicForm, 4>& minors) {
  const auto lines = common_lines(minors, pencil);
  if (!lines) return std::nullopt;
  FoundDyads found;
  found.complex_roots = lines->complex_lines;
  for (int i = 0; i < lines->count; ++i) {
    const CommonLines::Line& line = lines->lines[static_cast<std::size_t>(i)];
    (line.is_pair ? add_pair : add_single)(conditions, line.axis, found);
  }
  return found;
}

// By the first pencil whose planes part the lines well, else by the best.
std::optional<FoundDyads> find_dyads(const OrientationConditions& conditions) {
  constexpr double no_doubt = 1e-5;
  const std::array<CubicForm, 4> minors = minor_forms(one_of_them_symmetric(conditions));
  auto best = dyads_by(0, conditions, minors);
  for (int pencil = 1; best && best->doubt > no_doubt && pencil < line_pencils; ++pencil)
    if (const auto other = dyads_by(pencil, conditions, minors); other && other->doubt < best->doubt) best = other;
  return best;
}

void join_multiple(FoundDyads& found) {
  for (std::size_t i = 0; i < found.count; ++i)
    for (std::size_t j = found.count - 1; j > i; --j) {
      if (apart(found.dyads[i], found.dyads[j]) > tolerance::double_point) continue;
      found.multiplicity[i] += found.multiplicity[j];
      --found.count;
      found.dyads[j] = found.dyads[found.count];
      found.multiplicity[j] = found.multiplicity[found.count];
    }
}

bool has_line_of_partners(const OrientationConditions& conditions, Vector3 moving) {
  for (const Matrix3x3& a : conditions.rows)
    for (const Matrix3x3& b : conditions.rows)
      if (norm(cross(a * moving, b * moving)) > tolerance::line_of_partners) return false;
  return true;
}

SphericalDyadPoint point_of(const OrientationConditions& conditions, const SphericalDyad& dyad, int multiplicity) {
  const ConditionSteps at(conditions, with_acute_link(dyad));
  return {at.dyad, multiplicity, at.residual(), condition_of(at)};
}

// Fewer than four conditions are independent: what is left.
void explain_dependence(const OrientationConditions& conditions, int rank, FiveOrientationDyads& result) {
  OrientationConditions independent = without_row(conditions, 3);
  for (std::size_t row = 0; row < 3; ++row)
    if (auto other = without_row(conditions, row); other.singular.back() > independent.singular.back())
      independent = std::move(other);
  result.degeneracy = orientation_degeneracy({}, independent);
  if (result.degeneracy) return;
  result.curve = std::make_shared<const AxisCurve>(std::move(independent));
  const std::string kind(name(result.curve->kind()));
  result.degeneracy = {"dependent_rows",
                       fmt::format("The conditions of the five orientations depend on each other: {} are independent, "
                                   "and a whole curve of dyads ({}) satisfies all five. Solve them as a task of four "
                                   "orientations, or change one.",
                                   rank, kind),
                       {{"rank", static_cast<double>(rank)}, {"curve", kind}}};
}

Notice shared_component() {
  return {"common_component",
          "The five orientations are satisfied by more than separate dyads: a whole curve of dyads passes through all "
          "five. Drop one orientation and solve the other four, or change one.",
          {}};
}

Notice double_dyad(std::size_t index, int multiplicity) {
  return {"double_point",
          fmt::format("Dyad {} is a solution of multiplicity {}: a small change of an orientation moves it far, splits "
                      "it, or makes it vanish.",
                      index + 1, multiplicity),
          {{"point", static_cast<double>(index + 1)}, {"multiplicity", static_cast<double>(multiplicity)}}};
}

}  // namespace

FiveOrientationDyads five_orientation_dyads(const OrientationConditions& conditions) {
  require(conditions.rows.size() == 4, "the dyads are those of five orientations");
  FiveOrientationDyads result;
  const auto& singular = conditions.singular;
  const auto rank = std::count_if(singular.begin(), singular.end(),
                                  [&](double value) { return value > tolerance::dependent_rows * singular.front(); });
  if (rank < 4) {
    explain_dependence(conditions, static_cast<int>(rank), result);
    return result;
  }
  auto found = find_dyads(conditions);
  const auto partners_on_line = [&](const SphericalDyad& dyad) {
    return has_line_of_partners(conditions, dyad.moving_axis);
  };
  if (!found || std::any_of(found->dyads.begin(), found->dyads.begin() + found->count, partners_on_line)) {
    result.degeneracy = shared_component();
    return result;
  }
  join_multiple(*found);
  result.complex_roots = found->complex_roots;
  result.points.reserve(found->count);
  for (std::size_t i = 0; i < found->count; ++i)
    result.points.push_back(point_of(conditions, found->dyads[i], found->multiplicity[i]));
  std::sort(result.points.begin(), result.points.end(),
            [](const SphericalDyadPoint& a, const SphericalDyadPoint& b) { return a.dyad.angle() < b.dyad.angle(); });
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    result.points[i].dyad.coordinate = static_cast<double>(i) + 0.5;
    if (result.points[i].multiplicity > 1) result.warnings.push_back(double_dyad(i, result.points[i].multiplicity));
  }
  return result;
}

}  // namespace linkwright
