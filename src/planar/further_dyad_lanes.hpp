#pragma once

// The further dyads of five positions one of whose dyads is known, a task to each lane: the two conics of
// five_pose_lanes.hpp have that point in common, and through the others goes a binary cubic (docs/theory/path.md).
// Included by arm_lanes.hpp.

#include "planar/arm_kernel.hpp"
#include "planar/five_pose_lanes.hpp"

namespace linkwright::LINKWRIGHT_ISA {

/// Of the known dyad in the parameters' space, unit vector.
template <int Width>
LINKWRIGHT_INLINE Vector3<Real<Width>> known_parameters(const NumberSpace<Width>& space, const ArmBlock& block,
                                                        int at) {
  using R = Real<Width>;
  const R u = load<Width>(block.pivot[0] + at), v = load<Width>(block.pivot[1] + at);
  const R x = u + load<Width>(block.link[0][0] + at), y = v + load<Width>(block.link[0][1] + at);
  const double root_half = 0.5 * root_two;
  const R number[7] = {root_half * (x * u + y * v), root_half * (y * u - x * v), x, y, u, v, R{} + 1.0};
  Vector3<R> sum{};
  for (int i = 0; i < 7; ++i) sum = sum + number[i] * space.number[i];
  return normalized<Width>(sum);
}

/// A conic through the known point on a basis of what is across it: at m·known + s·e1 + t·e2 it is
/// m (slope_s s + slope_t t) + ss s² + st st + tt t².
template <int Width>
struct ThroughKnown {
  Real<Width> slope_s, slope_t, ss, st, tt;

  LINKWRIGHT_INLINE ThroughKnown(const Conic<Real<Width>>& conic, Vector3<Real<Width>> known,
                                 const Vector3<Real<Width>> (&e)[2]) {
    const auto at_known = conic * known, at_first = conic * e[0];
    slope_s = 2.0 * dot(at_known, e[0]);
    slope_t = 2.0 * dot(at_known, e[1]);
    ss = dot(at_first, e[0]);
    st = 2.0 * dot(at_first, e[1]);
    tt = dot(conic * e[1], e[1]);
  }
  LINKWRIGHT_INLINE Real<Width> slope(Real<Width> s) const { return slope_s * s + slope_t; }
  LINKWRIGHT_INLINE Real<Width> rest(Real<Width> s) const { return (ss * s + st) * s + tt; }
};

/// c[0] s³ + c[1] s²t + c[2] st² + c[3] t³ vanishes in the directions of the other points of both.
template <int Width>
LINKWRIGHT_INLINE Cubic<Width> cubic_of(const ThroughKnown<Width>& a, const ThroughKnown<Width>& b) {
  return {
      {a.slope_s * b.ss - b.slope_s * a.ss, a.slope_s * b.st + a.slope_t * b.ss - b.slope_s * a.st - b.slope_t * a.ss,
       a.slope_s * b.tt + a.slope_t * b.st - b.slope_s * a.tt - b.slope_t * a.st, a.slope_t * b.tt - b.slope_t * a.tt}};
}

/// Turns the basis so that the cubic's leading coefficient is large.
template <int Width>
LINKWRIGHT_INLINE void choose_leading(Vector3<Real<Width>> (&e)[2], const Cubic<Width>& cubic) {
  const auto [along, across] = leading_turn<Width>(cubic);
  const auto leading = along * e[0] + across * e[1];
  e[1] = (-across) * e[0] + along * e[1];
  e[0] = leading;
}

/// A Newton step on both conics where they cross at more than a hair's breadth; elsewhere none.
template <int Width>
LINKWRIGHT_INLINE Vector3<Real<Width>> polished(Vector3<Real<Width>> point, const Pencil<Width>& pencil) {
  using R = Real<Width>;
  constexpr double least_crossing = 1e-7;
  const auto by_e = pencil.e * point, by_f = pencil.f * point;
  const auto from_e = cross(by_f, point), from_f = cross(point, by_e);
  const R crossing = dot(by_e, from_e);
  const Mask crosses = less<Width>(R{} + least_crossing, magnitude<Width>(crossing));
  const R part = where<Width>(crosses, -0.5 / crossing);
  return normalized<Width>(point + part * dot(point, by_e) * from_e + part * dot(point, by_f) * from_f);
}

template <int Width>
LINKWRIGHT_INLINE void further_dyads(ArmBlock& block, Row<Width> (&rows)[4], int at) {
  using R = Real<Width>;
  Certainty<Width> any;  // a near miss shows in the residuals
  const NumberSpace<Width> space = number_space<Width>(rows, any);
  const Pencil<Width> pencil = pencil_of<Width>(space, any);
  const Vector3<R> known = known_parameters<Width>(space, block, at);
  const auto [u, v] = Tangents<Width>(known);
  Vector3<R> e[2] = {u, v};
  choose_leading<Width>(
      e, cubic_of<Width>(ThroughKnown<Width>(pencil.e, known, e), ThroughKnown<Width>(pencil.f, known, e)));
  const ThroughKnown<Width> of_e(pencil.e, known, e), of_f(pencil.f, known, e);
  const auto [c] = cubic_of<Width>(of_e, of_f);
  const R b = c[1] / c[0], d = c[2] / c[0];
  const R lone = lone_root<Width>(b, d, c[3] / c[0], any);
  // s² + ps + q is left.
  const R p = b + lone, q = d + lone * p, discriminant = 0.25 * p * p - q;
  const R far = -0.5 * p - with_sign_of<Width>(square_root<Width>(magnitude<Width>(discriminant)), p);
  const R roots[3] = {lone, far, q / far};
  const Mask three = negated<Width>(less<Width>(discriminant, R{}));
  for (int i = 0; i < 3; ++i) {
    const R s = roots[i], slope_e = of_e.slope(s), slope_f = of_f.slope(s);
    const Mask by_f = less<Width>(magnitude<Width>(slope_e), magnitude<Width>(slope_f));
    const R slope = select<Width>(by_f, slope_f, slope_e), rest = select<Width>(by_f, of_f.rest(s), of_e.rest(s));
    const auto direction = s * e[0] + e[1];
    auto point = normalized<Width>((-rest) * known + slope * direction);
    point = polished<Width>(polished<Width>(point, pencil), pencil);
    const Mask is_number = less<Width>(dot(point, point), R{} + 2.0);
    put_dyad<Width>(points_of_dyad<Width>(space, point), (i == 0 ? all_lanes<Width> : three) & is_number, block, i, at);
  }
}

}  // namespace linkwright::LINKWRIGHT_ISA
