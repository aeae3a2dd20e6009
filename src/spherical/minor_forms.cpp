#include "spherical/minor_forms.hpp"

#include <numbers>

#include "algebra/binary_form.hpp"

namespace linkwright {
namespace {

/// Coefficients of x², xy, xz, y², yz, z².
using QuadraticForm = std::array<double, 6>;

QuadraticForm operator+(QuadraticForm a, const QuadraticForm& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

// (u·W)(v·W) − (p·W)(q·W).
QuadraticForm difference_of_products(Vector3 u, Vector3 v, Vector3 p, Vector3 q) {
  return {u.x * v.x - p.x * q.x,
          u.x * v.y + u.y * v.x - p.x * q.y - p.y * q.x,
          u.x * v.z + u.z * v.x - p.x * q.z - p.z * q.x,
          u.y * v.y - p.y * q.y,
          u.y * v.z + u.z * v.y - p.y * q.z - p.z * q.y,
          u.z * v.z - p.z * q.z};
}

void add_product(Vector3 linear, const QuadraticForm& quadratic, CubicForm& to) {
  for (std::size_t i = 0; i < quadratic.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) to.coefficient[times_axis[i][axis]] += linear[axis] * quadratic[i];
}

/// DⱼW × DₖW, the part W (W·n), n = aⱼ × aₖ, by itself.
struct CrossForm {
  std::array<QuadraticForm, 3> rest;
  Vector3 normal;

  CrossForm(const ConditionParts& j, const ConditionParts& k) : normal(cross(j.skew, k.skew)) {
    const Matrix3x3 skew = skew_matrix(j.skew), whole = k.matrix();
    const auto cross_of = [](const Matrix3x3& p, const Matrix3x3& q, std::size_t i) {
      const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
      return difference_of_products(p.row[next], q.row[last], p.row[last], q.row[next]);
    };
    for (std::size_t i = 0; i < 3; ++i) rest[i] = cross_of(skew, k.symmetric, i) + cross_of(j.symmetric, whole, i);
  }

  /// Its inner product with DᵢW.
  [[nodiscard]] CubicForm along(const ConditionParts& i) const {
    const Matrix3x3 &s = i.symmetric, d = i.matrix();
    CubicForm form;
    add_product(normal, {s(0, 0), 2 * s(0, 1), 2 * s(0, 2), s(1, 1), 2 * s(1, 2), s(2, 2)}, form);
    for (std::size_t row = 0; row < 3; ++row) add_product(d.row[row], rest[row], form);
    return form;
  }
};

}  // namespace

ConditionParts parts_of(const OrientationConditions& conditions, std::size_t index) {
  if (!conditions.are_finite) {
    const Matrix3x3& d = conditions.rows[index];
    return {axial_vector(d), 0.5 * (d + transposed(d))};
  }
  const UnitQuaternion& turn = conditions.turns[index];
  const double sine = norm(turn.v());
  if (!(sine > 0)) return {};
  const Vector3 axis = turn.v() / sine;
  constexpr double half_root = 0.5 * std::numbers::sqrt2;  // |A − E| = √8 |v|
  return {(half_root * turn.w()) * axis, (half_root * sine) * (dyadic_product(axis, axis) - Matrix3x3::identity())};
}

CubicForm minor_form(const ConditionParts& first, const ConditionParts& second, const ConditionParts& third) {
  return CrossForm(second, third).along(first);
}

std::array<CubicForm, 4> minor_forms(const std::array<ConditionParts, 4>& conditions) {
  const auto& [a, b, c, d] = conditions;
  const CrossForm ab(a, b), cd(c, d);
  return {ab.along(c), ab.along(d), cd.along(a), cd.along(b)};
}

}  // namespace linkwright
