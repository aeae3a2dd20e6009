#pragma once

// The dyads of five finite poses, a task to each lane. Included by the five_pose_kernel_*.cpp files, one for each
// instruction set. The method is that of burmester_points() (docs/theory/planar.md, section 10), without branches: what
// would need one makes the lane unsure, and its task goes the careful way.

#include "core/pack_vector.hpp"
#include "planar/five_pose_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA {

template <int Width>
using Real = typename Pack<Width>::Real;

inline constexpr double root_two = 1.4142135623730951;

/// How far every decision, and every length that is divided by, must be from going the other way.
inline constexpr double least_margin = 1e-3;
/// Beyond it sine_cosine loses digits.
inline constexpr double largest_angle = 1e5;

/// Symmetric matrix.
template <class Real>
struct Conic {
  Real xx, xy, xz, yy, yz, zz;

  LINKWRIGHT_INLINE Vector3<Real> row_x() const { return {xx, xy, xz}; }
  LINKWRIGHT_INLINE Vector3<Real> row_y() const { return {xy, yy, yz}; }
  LINKWRIGHT_INLINE Vector3<Real> row_z() const { return {xz, yz, zz}; }
  LINKWRIGHT_INLINE Vector3<Real> operator*(Vector3<Real> v) const {
    return {dot(row_x(), v), dot(row_y(), v), dot(row_z(), v)};
  }
};

template <class Real>
LINKWRIGHT_INLINE Conic<Real> combined(Real s, const Conic<Real>& a, Real t, const Conic<Real>& b) {
  return {s * a.xx + t * b.xx, s * a.xy + t * b.xy, s * a.xz + t * b.xz,
          s * a.yy + t * b.yy, s * a.yz + t * b.yz, s * a.zz + t * b.zz};
}
template <class Real>
LINKWRIGHT_INLINE Real inner(const Conic<Real>& a, const Conic<Real>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2.0 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}
/// Determinant times inverse.
template <class Real>
LINKWRIGHT_INLINE Conic<Real> adjugate(const Conic<Real>& m) {
  return {m.yy * m.zz - m.yz * m.yz, m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy,
          m.xx * m.zz - m.xz * m.xz, m.xy * m.xz - m.xx * m.yz, m.xx * m.yy - m.xy * m.xy};
}
/// The product of two linear forms, times 2.
template <class Real>
LINKWRIGHT_INLINE Conic<Real> product(Vector3<Real> u, Vector3<Real> v) {
  return {2.0 * u.x * v.x, u.x * v.y + u.y * v.x, u.x * v.z + u.z * v.x,
          2.0 * u.y * v.y, u.y * v.z + u.z * v.y, 2.0 * u.z * v.z};
}

// ---- the conditions -------------------------------------------------------------------------------------------------

/// The seven numbers of a row (planar/five_conditions.hpp).
template <int Width>
using Row = Real<Width>[7];

/// A Householder reflection of the entries from `First` on; it takes all but the first of them from a row.
template <int Width, int First>
struct Reflection {
  Row<Width> axis;
  Real<Width> factor;  ///< 2 / |axis|²
  Real<Width> length;  ///< what is left of the row in its first entry

  LINKWRIGHT_INLINE explicit Reflection(const Row<Width>& v) {
    Real<Width> squared{};
    for (int i = First; i < 7; ++i) squared += v[i] * v[i];
    length = square_root<Width>(squared);
    for (int i = First; i < 7; ++i) axis[i] = v[i];
    axis[First] += with_sign_of<Width>(length, v[First]);
    factor = 1.0 / (length * (length + magnitude<Width>(v[First])));
  }
  LINKWRIGHT_INLINE void apply(Row<Width>& v) const {
    Real<Width> along = axis[First] * v[First];
    for (int i = First + 1; i < 7; ++i) along += axis[i] * v[i];
    along *= factor;
    for (int i = First; i < 7; ++i) v[i] -= along * axis[i];
  }
};

/// Unit rows of the conditions at poses 2 to 5 relative to pose 1. Gives the characteristic length, their unit.
template <int Width>
LINKWRIGHT_INLINE Real<Width> condition_rows(const FivePoseBlock& block, int at, Row<Width> (&rows)[4],
                                             Certainty<Width>& certainty) {
  using R = Real<Width>;
  const auto fetch = [&](const double* from) { return load<Width>(from + at); };
  R a_x[4], a_y[4], sum_a{}, sum_q{};
  SineCosine<Width> half[4];
  for (int j = 0; j < 4; ++j) {
    a_x[j] = fetch(block.x[j + 1]) - fetch(block.x[0]);
    a_y[j] = fetch(block.y[j + 1]) - fetch(block.y[0]);
    const R angle = (fetch(block.angle[j + 1]) - fetch(block.angle[0])) * 0.5;
    certainty.demand(largest_angle - magnitude<Width>(angle), 0);
    half[j] = sine_cosine<Width>(angle);
    sum_a += a_x[j] * a_x[j] + a_y[j] * a_y[j];
    sum_q += 4.0 * half[j].sine * half[j].sine;
  }
  certainty.demand(sum_q, least_margin);
  certainty.demand(sum_a, 0);
  const R length = square_root<Width>(sum_a / sum_q);
  for (int j = 0; j < 4; ++j) {
    const R x = a_x[j] / length, y = a_y[j] / length, s = half[j].sine, c = half[j].cosine;
    const R r_x = c * c - s * s, r_y = 2.0 * s * c, q_x = 2.0 * s * s, q_y = -2.0 * s * c;  // q = 1 − r
    const R square = x * x + y * y, k = square * 0.5;
    const R size = 1.0 / square_root<Width>(8.0 * s * s + 2.0 * square + k * k);
    rows[j][0] = size * root_two * q_x;
    rows[j][1] = -size * root_two * q_y;
    rows[j][2] = size * (r_x * x + r_y * y);
    rows[j][3] = size * (r_x * y - r_y * x);
    rows[j][4] = -size * x;
    rows[j][5] = -size * y;
    rows[j][6] = size * k;
  }
  return length;
}

/// The numbers that meet the rows, linear in three parameters: a vector of parameters each.
template <int Width>
struct NumberSpace {
  Vector3<Real<Width>> number[7];
};

template <int Width>
LINKWRIGHT_INLINE NumberSpace<Width> number_space(Row<Width> (&rows)[4], Certainty<Width>& certainty) {
  using R = Real<Width>;
  const Reflection<Width, 0> one(rows[0]);
  for (int j = 1; j < 4; ++j) one.apply(rows[j]);
  const Reflection<Width, 1> two(rows[1]);
  for (int j = 2; j < 4; ++j) two.apply(rows[j]);
  const Reflection<Width, 2> three(rows[2]);
  three.apply(rows[3]);
  const Reflection<Width, 3> four(rows[3]);
  // The rows have unit length: what is left of each says how far it is independent of those before.
  for (const R& left : {two.length, three.length, four.length}) certainty.demand(left, least_margin);
  Row<Width> basis[3];
  for (int n = 0; n < 3; ++n) {
    for (int i = 0; i < 7; ++i) basis[n][i] = R{} + (i == 4 + n ? 1.0 : 0.0);
    four.apply(basis[n]);
    three.apply(basis[n]);
    two.apply(basis[n]);
    one.apply(basis[n]);
  }
  NumberSpace<Width> space;
  for (int i = 0; i < 7; ++i) space.number[i] = {basis[0][i], basis[1][i], basis[2][i]};
  return space;
}

// ---- two conics -----------------------------------------------------------------------------------------------------

template <int Width>
struct Pencil {
  Conic<Real<Width>> e, f;  ///< orthonormal as vectors of nine entries
};

/// Of the two conics where seven numbers are those of a pair of points.
template <int Width>
LINKWRIGHT_INLINE Pencil<Width> pencil_of(const NumberSpace<Width>& space, Certainty<Width>& certainty) {
  using R = Real<Width>;
  const auto& [p, q, x, y, u, v, w] = space.number;
  const R one = R{} + 1.0, root = R{} + root_two, minus = R{} - 1.0;
  const auto unit = [&](const Conic<R>& conic, R& size) {
    size = square_root<Width>(inner(conic, conic));
    return combined(1.0 / size, conic, R{}, conic);
  };
  R size_of_real, size_of_imaginary, size_of_rest;
  const auto real =
      unit(combined(one, combined(root, product(p, w), minus, product(x, u)), minus, product(y, v)), size_of_real);
  const auto imaginary =
      unit(combined(one, combined(root, product(q, w), minus, product(y, u)), one, product(x, v)), size_of_imaginary);
  const Conic<R> f = unit(combined(one, imaginary, -inner(real, imaginary), real), size_of_rest);
  certainty.demand(smaller(size_of_rest, smaller(size_of_real, size_of_imaginary)), least_margin);
  return {real, f};
}

/// det(tE + F) = c[0] t³ + c[1] t² + c[2] t + c[3].
template <int Width>
struct Cubic {
  Real<Width> c[4];
};

template <int Width>
LINKWRIGHT_INLINE Cubic<Width> determinant_of(const Pencil<Width>& pencil) {
  const auto of_e = adjugate(pencil.e), of_f = adjugate(pencil.f);
  return {dot(pencil.e.row_x(), of_e.row_x()), inner(of_e, pencil.f), inner(of_f, pencil.e),
          dot(pencil.f.row_x(), of_f.row_x())};
}

/// A turn of a basis by a multiple of 45°: the first of the new basis is along·first + across·second.
template <int Width>
struct BasisTurn {
  Real<Width> along, across;
};

/// After which the leading coefficient of a binary cubic is as large as it can be.
template <int Width>
LINKWRIGHT_INLINE BasisTurn<Width> leading_turn(const Cubic<Width>& cubic) {
  using R = Real<Width>;
  const auto& c = cubic.c;
  const double root_eighth = 0.35355339059327379, root_half = 0.70710678118654757;
  const R sum = magnitude<Width>(root_eighth * ((c[0] + c[2]) + (c[1] + c[3])));
  const R difference = magnitude<Width>(root_eighth * ((c[0] + c[2]) - (c[1] + c[3])));
  const R first = magnitude<Width>(c[0]), last = magnitude<Width>(c[3]);
  const Mask straight = negated<Width>(less<Width>(larger(first, last), larger(sum, difference)));
  const Mask swapped = less<Width>(first, last), other_sign = less<Width>(sum, difference);
  const R one = R{} + 1.0, s = R{} + root_half;
  return {select<Width>(straight, where<Width>(negated<Width>(swapped), one), s),
          select<Width>(straight, where<Width>(swapped, one), select<Width>(other_sign, -s, s))};
}

/// Turns the basis of the pencil so that its cubic's leading coefficient is large.
template <int Width>
LINKWRIGHT_INLINE Cubic<Width> choose_leading(Pencil<Width>& pencil) {
  const auto [to_e, to_f] = leading_turn<Width>(determinant_of<Width>(pencil));
  pencil = {combined(to_e, pencil.e, to_f, pencil.f), combined(-to_f, pencil.e, to_e, pencil.f)};
  return determinant_of<Width>(pencil);
}

/// The real root of t³ + bt² + ct + d that stands apart from the other two: its distance from the mean of the three is
/// the only positive root of u³ − 3pu − 2|r|, which Halley's steps reach from above, 1e-10 after the third wherever it
/// starts; Newton's on the cubic itself follows.
template <int Width>
LINKWRIGHT_INLINE Real<Width> lone_root(Real<Width> b, Real<Width> c, Real<Width> d, Certainty<Width>& certainty) {
  using R = Real<Width>;
  const R third = b * (1.0 / 3), p = (b * b - 3.0 * c) * (1.0 / 9);
  const R r = third * third * third - (third * c - d) * 0.5, size = magnitude<Width>(r);
  const Mask three_real = less<Width>(R{}, p);
  const R by_size = 2.0 * cube_root_estimate<Width>(size);
  const R by_p = 2.0 * square_root<Width>(magnitude<Width>(p));
  R u = select<Width>(three_real, larger(by_size, by_p), smaller(by_size, size * 2.0 / (3.0 * magnitude<Width>(p))));
  for (int i = 0; i < 3; ++i) {
    const R value = (u * u - 3.0 * p) * u - 2.0 * size, slope = 3.0 * (u * u - p);
    u -= value * slope / (slope * slope - 3.0 * u * value);
  }
  R t = -third - with_sign_of<Width>(u, r);
  const auto slope_at = [&](R at) { return (3.0 * at + 2.0 * b) * at + c; };
  t -= (((t + b) * t + c) * t + d) / slope_at(t);
  certainty.demand(magnitude<Width>(slope_at(t)), least_margin);
  return t;
}

/// Two lines that meet another conic where all conics of the pencil meet.
template <int Width>
struct LinePair {
  Vector3<Real<Width>> line[2];  ///< unit vectors
  Conic<Real<Width>> other;
  Mask real;
};

template <int Width>
LINKWRIGHT_INLINE LinePair<Width> lines_in(Pencil<Width> pencil, Certainty<Width>& certainty) {
  using R = Real<Width>;
  const auto [cubic] = choose_leading<Width>(pencil);
  certainty.demand(magnitude<Width>(cubic[0]), least_margin);
  const R scale = 1.0 / cubic[0];
  const R t = lone_root<Width>(cubic[1] * scale, cubic[2] * scale, cubic[3] * scale, certainty);
  const R to_f = 1.0 / square_root<Width>(1.0 + t * t), to_e = t * to_f;
  const Conic<R> pair = combined(to_e, pencil.e, to_f, pencil.f), other = combined(to_f, pencil.e, -to_e, pencil.f);
  // The minors of l mᵀ + m lᵀ are those of its vertex l × m, against the sign of the square.
  const Conic<R> minors = adjugate(pair);
  const R x = magnitude<Width>(minors.xx), y = magnitude<Width>(minors.yy), z = magnitude<Width>(minors.zz);
  const Mask by_x = negated<Width>(less<Width>(x, larger(y, z))), by_y = negated<Width>(less<Width>(y, z));
  const R square = select<Width>(by_x, minors.xx, select<Width>(by_y, minors.yy, minors.zz));
  certainty.demand(magnitude<Width>(square), least_margin);
  const Mask real = less<Width>(square, R{});
  const auto longest = select<Width>(by_x, minors.row_x(), select<Width>(by_y, minors.row_y(), minors.row_z()));
  const auto vertex = 1.0 / square_root<Width>(magnitude<Width>(square)) * longest;
  // A pair of complex lines has its vertex for the one real point, which the other conic must miss.
  certainty.demand(magnitude<Width>(dot(vertex, other * vertex)), least_margin, negated<Width>(real));
  // The pair of lines and the cross product with its vertex make l mᵀ or m lᵀ.
  const Vector3<R> rows[3] = {{pair.xx, pair.xy - vertex.z, pair.xz + vertex.y},
                              {pair.xy + vertex.z, pair.yy, pair.yz - vertex.x},
                              {pair.xz - vertex.y, pair.yz + vertex.x, pair.zz}};
  const R first = dot(rows[0], rows[0]), second = dot(rows[1], rows[1]), third = dot(rows[2], rows[2]);
  const Mask by_first = negated<Width>(less<Width>(first, larger(second, third)));
  const Mask by_second = negated<Width>(less<Width>(second, third));
  const auto m = select<Width>(by_first, rows[0], select<Width>(by_second, rows[1], rows[2]));
  const Vector3<R> l = {dot(rows[0], m), dot(rows[1], m), dot(rows[2], m)};
  return {{normalized<Width>(l), normalized<Width>(m)}, other, real};
}

/// Two points of the parameters' plane and where they are real.
template <int Width>
struct PointPair {
  Vector3<Real<Width>> point[2];
  Mask real;
};

/// Where a line meets a conic: a s² + 2b st + c t² = 0 on an orthonormal basis of the line, in the lanes of `real`.
template <int Width>
LINKWRIGHT_INLINE PointPair<Width> cut(Vector3<Real<Width>> line, const Conic<Real<Width>>& conic, Mask real,
                                       Certainty<Width>& certainty) {
  using R = Real<Width>;
  const auto [u, v] = Tangents<Width>(line);
  const Vector3<R> image = conic * u;
  const R a = dot(u, image), b = dot(v, image), c = dot(v, conic * v);
  const R discriminant = b * b - a * c, distance = magnitude<Width>(discriminant);
  const R spread = (a - c) * (a - c) * 0.25 + b * b + distance;
  certainty.demand(spread, least_margin * least_margin, real);
  // sin² of the angle between the two points, negative where they are complex.
  certainty.demand(distance / spread, least_margin, real);
  const R q = -b - with_sign_of<Width>(square_root<Width>(distance), b);
  return {{normalized<Width>(q * u + a * v), normalized<Width>(c * u + q * v)}, real & less<Width>(R{}, discriminant)};
}

/// A Newton step on both conics, square to the point; |det(∂E, ∂F, point)| must not be small.
template <int Width>
LINKWRIGHT_INLINE Vector3<Real<Width>> corrected(Vector3<Real<Width>> point, const Pencil<Width>& pencil, Mask real,
                                                 Certainty<Width>& certainty) {
  using R = Real<Width>;
  const auto by_e = pencil.e * point, by_f = pencil.f * point;
  const auto from_e = cross(by_f, point), from_f = cross(point, by_e);
  const R crossing = dot(by_e, from_e);
  certainty.demand(magnitude<Width>(crossing), least_margin, real);
  const R part = -0.5 / crossing;
  return normalized<Width>(point + part * dot(point, by_e) * from_e + part * dot(point, by_f) * from_f);
}

// ---- dyads ----------------------------------------------------------------------------------------------------------

/// The point of a complex pair (w, z) known up to a complex factor, which a real w takes away.
template <class Real>
LINKWRIGHT_INLINE Vector3<Real> point_of(Real w_x, Real w_y, Real z_x, Real z_y) {
  return {w_x * w_x + w_y * w_y, z_x * w_x + z_y * w_y, z_y * w_x - z_x * w_y};
}

/// The pair of points that seven numbers stand for.
template <int Width>
struct PointsOfDyad {
  Vector3<Real<Width>> circle, center;  ///< unit vectors, w ≥ 0
  Real<Width> least_square;             ///< of the vectors that they are read from, the shorter one
};

/// [[w w′, w C̄], [z w′, z C̄]] is the product of the columns (w, z) and (w′, C̄): each row and each column of it names a
/// point, the longer the better.
template <int Width>
LINKWRIGHT_INLINE PointsOfDyad<Width> points_of_dyad(const NumberSpace<Width>& space, Vector3<Real<Width>> parameters) {
  using R = Real<Width>;
  R n[7];
  for (int i = 0; i < 7; ++i) n[i] = dot(space.number[i], parameters);
  const R p_x = root_two * n[0], p_y = root_two * n[1], w = n[6];
  const R far_circle = n[2] * n[2] + n[3] * n[3], far_center = n[4] * n[4] + n[5] * n[5];
  const R finite_center = w * w + far_circle, finite_circle = w * w + far_center;
  const Mask by_center = negated<Width>(less<Width>(finite_center, far_center));
  const Mask by_circle = negated<Width>(less<Width>(finite_circle, far_circle));
  const R factor = with_sign_of<Width>(R{} + 1.0, w);
  const auto circle = select<Width>(by_center, factor * Vector3<R>{w, n[2], n[3]}, point_of<R>(n[4], -n[5], p_x, p_y));
  const auto center = select<Width>(by_circle, factor * Vector3<R>{w, n[4], n[5]}, point_of<R>(n[2], -n[3], p_x, -p_y));
  return {normalized<Width>(circle), normalized<Width>(center),
          smaller(larger(finite_center, far_center), larger(finite_circle, far_circle))};
}

/// To one of the places of a block.
template <int Width, class Block>
LINKWRIGHT_INLINE void put_dyad(const PointsOfDyad<Width>& dyad, Mask real, Block& block, int place, int at) {
  store_vector<Width>(dyad.circle, block.circle[place], at);
  store_vector<Width>(dyad.center, block.center[place], at);
  store<Width>(bytes<Width>(real), block.real[place] + at);
}

template <int Width>
LINKWRIGHT_INLINE void five_poses(FivePoseBlock& block, int at) {
  Certainty<Width> certainty;
  Row<Width> rows[4];
  store<Width>(condition_rows<Width>(block, at, rows, certainty), block.length + at);
  const NumberSpace<Width> space = number_space<Width>(rows, certainty);
  const Pencil<Width> pencil = pencil_of<Width>(space, certainty);
  const LinePair<Width> lines = lines_in<Width>(pencil, certainty);
  Vector3<Real<Width>> points[4];
  Mask real[4];
  for (int i = 0; i < 2; ++i) {
    const PointPair<Width> met = cut<Width>(lines.line[i], lines.other, lines.real, certainty);
    for (int k = 0; k < 2; ++k) {
      auto point = corrected<Width>(met.point[k], pencil, met.real, certainty);
      points[2 * i + k] = corrected<Width>(point, pencil, met.real, certainty);
      real[2 * i + k] = met.real;
    }
  }
  for (int i = 0; i < 4; ++i) {
    for (int k = i + 1; k < 4; ++k) {
      const auto apart = cross(points[i], points[k]);
      certainty.demand(dot(apart, apart), least_margin * least_margin, real[i] & real[k]);
    }
    const PointsOfDyad<Width> dyad = points_of_dyad<Width>(space, points[i]);
    certainty.demand(dyad.least_square, least_margin * least_margin, real[i]);
    put_dyad<Width>(dyad, real[i], block, i, at);
  }
  store<Width>(bytes<Width>(certainty.sure), block.sure + at);
}

template <int Width>
void five_pose_kernel(FivePoseBlock& block) {
  for (int at = 0; at < FivePoseBlock::size; at += Width) five_poses<Width>(block, at);
}

}  // namespace linkwright::LINKWRIGHT_ISA
