#include "planar/five_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linkwright/algebra/point.hpp"

namespace linkwright {
namespace {

// Symmetric matrix of the product of two linear forms.
void add_product(HomogeneousMatrix& sum, Homogeneous u, Homogeneous v, double factor) {
  const double half = factor / 2;
  sum.row[0] = sum.row[0] + half * (u.w * v + v.w * u);
  sum.row[1] = sum.row[1] + half * (u.x * v + v.x * u);
  sum.row[2] = sum.row[2] + half * (u.y * v + v.y * u);
}

/// A Householder reflection of the entries from `First` on. The places are known when compiling, which halves the time.
template <std::size_t First>
struct Reflection {
  ConditionRow axis{};
  double factor = 0;  ///< 2 / |axis|²

  /// That which takes all but the first entry of v away.
  explicit Reflection(const ConditionRow& v) {
    double squared = 0;
    for (std::size_t i = First; i < 7; ++i) squared += v[i] * v[i];
    if (!(squared > 0)) return;
    const double length = std::sqrt(squared);
    for (std::size_t i = First; i < 7; ++i) axis[i] = v[i];
    axis[First] += std::copysign(length, v[First]);
    factor = 1 / (length * (length + std::abs(v[First])));
  }
  void apply(ConditionRow& v) const {
    double along = 0;
    for (std::size_t i = First; i < 7; ++i) along += axis[i] * v[i];
    along *= factor;
    for (std::size_t i = First; i < 7; ++i) v[i] -= along * axis[i];
  }
};

// The homogeneous point of a complex pair (w, z) known up to a complex factor; w is made real.
Homogeneous real_point(Point w, Point z) {
  const double size = std::abs(w);
  if (!(size > 0)) return {0, z.real(), z.imag()};
  const Point turned = z * std::conj(w) / size;
  return {size, turned.real(), turned.imag()};
}

}  // namespace

DyadSpace dyad_space(const ConditionRows& rows) {
  auto [first, second, third, fourth] = rows;
  const Reflection<0> one(first);
  for (ConditionRow* row : {&second, &third, &fourth}) one.apply(*row);
  const Reflection<1> two(second);
  for (ConditionRow* row : {&third, &fourth}) two.apply(*row);
  const Reflection<2> three(third);
  three.apply(fourth);
  const Reflection<3> four(fourth);
  std::array<ConditionRow, 3> basis{};
  for (std::size_t n = 0; n < 3; ++n) {
    basis[n][4 + n] = 1;
    four.apply(basis[n]);
    three.apply(basis[n]);
    two.apply(basis[n]);
    one.apply(basis[n]);
  }
  DyadSpace space;
  for (std::size_t i = 0; i < 7; ++i) space[i] = {basis[0][i], basis[1][i], basis[2][i]};
  return space;
}

ConicIntersection dyads_in(const DyadSpace& space) {
  const auto& [p, q, x, y, u, v, w] = space;
  HomogeneousMatrix real{}, imaginary{};
  add_product(real, p, w, std::numbers::sqrt2);
  add_product(real, x, u, -1);
  add_product(real, y, v, -1);
  add_product(imaginary, q, w, std::numbers::sqrt2);
  add_product(imaginary, y, u, -1);
  add_product(imaginary, x, v, 1);
  return intersection_of(real, imaginary);
}

Dyad factors_of(const DyadSpace& space, Homogeneous parameters) {
  std::array<double, 7> n{};
  for (std::size_t i = 0; i < 7; ++i) n[i] = dot(space[i], parameters);
  // [[W, ῡ], [ξ, p]] is the product of the columns (w, z) and (w′, C̄): every row and column of it names a point, the
  // longer the better, but the turn of a point is told by its w alone.
  const Point p{std::numbers::sqrt2 * n[0], std::numbers::sqrt2 * n[1]}, xi{n[2], n[3]}, upsilon{n[4], n[5]};
  const double w = n[6];
  const double finite_center = w * w + std::norm(xi), far_center = std::norm(upsilon);
  const double finite_circle = w * w + std::norm(upsilon), far_circle = std::norm(xi);
  if (!(std::max(finite_center, finite_circle) > 0))
    return {normalized(Homogeneous::at_infinity(std::conj(p))), {0, 1, 0}, 0};
  const bool by_center = finite_center >= far_center;
  const bool by_circle = finite_circle >= far_circle;
  const Homogeneous circle = by_center ? (w < 0 ? Homogeneous{-w, -n[2], -n[3]} : Homogeneous{w, n[2], n[3]})
                                       : real_point(std::conj(upsilon), p);
  const Homogeneous center = by_circle ? (w < 0 ? Homogeneous{-w, -n[4], -n[5]} : Homogeneous{w, n[4], n[5]})
                                       : real_point(std::conj(xi), std::conj(p));
  return {normalized(center), normalized(circle), 0};
}

bool comes_before(const Dyad& a, const Dyad& b) {
  if (a.circle.w != b.circle.w) return a.circle.w > b.circle.w;
  if (a.center.w != b.center.w) return a.center.w > b.center.w;
  if (a.circle.x != b.circle.x) return a.circle.x < b.circle.x;
  return a.circle.y < b.circle.y;
}

}  // namespace linkwright
