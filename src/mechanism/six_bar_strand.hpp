#pragma once

#include "core/pack_vector.hpp"
#include "six_bar_lanes.hpp"

// The curve of configurations of a six-bar near one of its points, a six-bar to each lane: one source for the walk of
// one (six_bar_walk.cpp) and of several at once (six_bar_kernel.cpp).
namespace linkwright::LINKWRIGHT_ISA {

template <class Real>
struct Vector4 {
  Real of[4];
};

/// Of the Gram matrix J Jᵀ = L D Lᵀ the triangle L, whose diagonal is 1, and the inverse of D: no roots are needed.
template <int Width>
struct GramFactor {
  using Real = typename Pack<Width>::Real;
  Real l[4][4], per[4];
  Mask regular = all_lanes<Width>;

  LINKWRIGHT_INLINE explicit GramFactor(const Real (&gram)[4][4]) {
    Real scaled[4][4];  // L D
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < i; ++k) {
        Real sum = gram[i][k];
        for (int m = 0; m < k; ++m) sum -= scaled[i][m] * l[k][m];
        scaled[i][k] = sum;
        l[i][k] = sum * per[k];
      }
      Real rest = gram[i][i];
      for (int m = 0; m < i; ++m) rest -= scaled[i][m] * l[i][m];
      const Mask positive = less<Width>(Real{}, rest);
      regular &= positive;
      per[i] = where<Width>(positive, 1.0 / select<Width>(positive, rest, Real{} + 1.0));
    }
  }

  /// L⁻¹ b.
  LINKWRIGHT_INLINE Vector4<Real> forwards(Vector4<Real> b) const {
    for (int i = 0; i < 4; ++i)
      for (int m = 0; m < i; ++m) b.of[i] -= l[i][m] * b.of[m];
    return b;
  }
  /// (J Jᵀ)⁻¹ b.
  LINKWRIGHT_INLINE Vector4<Real> solution(Vector4<Real> b) const {
    b = forwards(b);
    for (int i = 0; i < 4; ++i) b.of[i] *= per[i];
    for (int i = 3; i >= 0; --i)
      for (int m = i + 1; m < 4; ++m) b.of[i] -= l[m][i] * b.of[m];
    return b;
  }
  /// |J⁺ b|² = bᵀ (J Jᵀ)⁻¹ b.
  LINKWRIGHT_INLINE Real squares_of_solution(Vector4<Real> b) const {
    b = forwards(b);
    return b.of[0] * b.of[0] * per[0] + b.of[1] * b.of[1] * per[1] + b.of[2] * b.of[2] * per[2] +
           b.of[3] * b.of[3] * per[3];
  }
};

template <class Real>
LINKWRIGHT_INLINE Real squares(const Vector4<Real>& v) {
  return v.of[0] * v.of[0] + v.of[1] * v.of[1] + v.of[2] * v.of[2] + v.of[3] * v.of[3];
}

/// Terms of bodies 1 … 5 in both loops, and the loops' errors.
template <int Width>
struct LoopTerms {
  using Real = typename Pack<Width>::Real;
  Vector<Real> u[5], v[5], f, g;
};

// The Jacobian's columns are i·(uᵢ, vᵢ). Turned back by i, which changes neither the Gram matrix nor lengths, they are
// the terms themselves.
template <class Real>
LINKWRIGHT_INLINE Vector4<Real> column(Vector<Real> u, Vector<Real> v) {
  return {{u.x, u.y, v.x, v.y}};
}
template <class Real>
LINKWRIGHT_INLINE Vector4<Real> turned_column(Vector<Real> u, Vector<Real> v) {
  return {{-u.y, u.x, -v.y, v.x}};
}

/// Signed minors of the 4 × 5 Jacobian: (−1)^j times the determinant without the column of body j + 1.
template <int Width>
LINKWRIGHT_INLINE void minors_of(const LoopTerms<Width>& terms, typename Pack<Width>::Real (&minors)[5]) {
  using Real = typename Pack<Width>::Real;
  Real mu[5][5], mv[5][5];
  for (int i = 0; i < 5; ++i)
    for (int k = i + 1; k < 5; ++k) {
      mu[i][k] = cross(terms.u[i], terms.u[k]);
      mv[i][k] = cross(terms.v[i], terms.v[k]);
    }
  for (int j = 0; j < 5; ++j) {
    int k[4] = {};
    for (int i = 0, n = 0; i < 5; ++i)
      if (i != j) k[n++] = i;
    const Real determinant = mu[k[0]][k[1]] * mv[k[2]][k[3]] - mu[k[0]][k[2]] * mv[k[1]][k[3]] +
                             mu[k[0]][k[3]] * mv[k[1]][k[2]] + mu[k[1]][k[2]] * mv[k[0]][k[3]] -
                             mu[k[1]][k[3]] * mv[k[0]][k[2]] + mu[k[2]][k[3]] * mv[k[0]][k[1]];
    minors[j] = j % 2 == 0 ? determinant : -determinant;
  }
}

/// A ball about a point in which the curve is one strand (SixBarStrand).
template <int Width>
struct StrandBall {
  using Real = typename Pack<Width>::Real;
  Real tangent[5], correction[5];
  Real reach;     ///< 0 where the Jacobian is singular
  Real sine_4th;  ///< fourth power of SixBarTransmission::sine where the loops do not fall apart
};

// With J the Jacobian and J⁺ its inverse on the planes normal to the tangent, body i's column changes over a distance d
// by at most dᵢ times a vector of the plane of that column and the column turned by a right angle: after J⁺ at most
// βᵢ dᵢ, βᵢ² = |J⁺ i cᵢ|² + |J⁺ cᵢ|². With Λ = max βᵢ the Jacobian thus stays regular on those planes within |d| < 1/Λ,
// and the loops are injective on the part of each plane within the ball: one strand. At a quarter of that radius the
// strand's slope against the tangent is at most (1/4)/(1 − 1/4) = 1/3 and Newton's method converges from the tangent
// (Kantorovich). Units of the loops and their combination do not matter.
template <int Width>
LINKWRIGHT_INLINE StrandBall<Width> strand_ball(const LoopTerms<Width>& terms) {
  using Real = typename Pack<Width>::Real;
  Real gram[4][4] = {};
  for (int i = 0; i < 5; ++i) {
    const Vector4<Real> c = column(terms.u[i], terms.v[i]);
    for (int r = 0; r < 4; ++r)
      for (int k = 0; k <= r; ++k) gram[r][k] += c.of[r] * c.of[k];
  }
  const GramFactor<Width> factor(gram);
  Real minors[5];
  minors_of<Width>(terms, minors);
  Real volume_square = {}, columns = Real{} + 1.0, steepest = {};
  for (int i = 0; i < 5; ++i) volume_square += minors[i] * minors[i];
  const Mask regular = factor.regular & less<Width>(Real{}, volume_square);
  const Real per_volume =
      where<Width>(regular, 1.0 / square_root<Width>(select<Width>(regular, volume_square, Real{} + 1.0)));

  StrandBall<Width> ball;
  // J δ = −F with J = i·column: the columns' sum Σ cᵢ δᵢ is i F.
  const Vector4<Real> weights = factor.solution(turned_column(terms.f, terms.g));
  for (int i = 0; i < 5; ++i) {
    const Vector4<Real> c = column(terms.u[i], terms.v[i]);
    steepest = larger(
        steepest, factor.squares_of_solution(c) + factor.squares_of_solution(turned_column(terms.u[i], terms.v[i])));
    ball.tangent[i] = minors[i] * per_volume;
    ball.correction[i] = where<Width>(
        regular, c.of[0] * weights.of[0] + c.of[1] * weights.of[1] + c.of[2] * weights.of[2] + c.of[3] * weights.of[3]);
    if (i > 0) columns = columns * squares(c);
  }
  const Mask steep = regular & less<Width>(Real{}, steepest);
  ball.reach = where<Width>(steep, 0.25 / square_root<Width>(select<Width>(steep, steepest, Real{} + 1.0)));
  ball.sine_4th = minors[0] * minors[0] / columns;
  return ball;
}

/// The unit vector after a step of `way`: the angle x turns by 2 atan(x/2), which needs no trigonometry.
template <int Width>
LINKWRIGHT_INLINE Vector<typename Pack<Width>::Real> stepped(Vector<typename Pack<Width>::Real> turn,
                                                             typename Pack<Width>::Real way) {
  using Real = typename Pack<Width>::Real;
  const Real q = 0.25 * way * way, per = 1.0 / (1.0 + q);
  const Vector<Real> r = product(turn, {(1.0 - q) * per, way * per});
  return 0.5 * (3.0 - dot(r, r)) * r;  // rounding must not add up
}

template <int Width>
LINKWRIGHT_INLINE LoopTerms<Width> terms_at(const StrandLanes& lanes, int at,
                                            const Vector<typename Pack<Width>::Real> (&turn)[5]) {
  LoopTerms<Width> terms;
  terms.f = load_vector<Width>(lanes.ground[0], at);
  terms.g = load_vector<Width>(lanes.ground[1], at);
  for (int i = 0; i < 5; ++i) {
    terms.u[i] = product(load_vector<Width>(lanes.coefficient[0][i], at), turn[i]);
    terms.v[i] = product(load_vector<Width>(lanes.coefficient[1][i], at), turn[i]);
    terms.f = terms.f + terms.u[i];
    terms.g = terms.g + terms.v[i];
  }
  return terms;
}

/// Squared chords from where the lanes are to a place.
template <int Width>
LINKWRIGHT_INLINE typename Pack<Width>::Real chords(const LaneVector (&place)[5], int at,
                                                    const Vector<typename Pack<Width>::Real> (&turn)[5]) {
  typename Pack<Width>::Real sum = {};
  for (int i = 0; i < 5; ++i) {
    const auto way = turn[i] - load_vector<Width>(place[i], at);
    sum += dot(way, way);
  }
  return sum;
}

template <int Width>
LINKWRIGHT_INLINE bool strands_step(StrandLanes& lanes, int at) {
  using Real = typename Pack<Width>::Real;
  const auto of = [at](const LaneReal& value) { return load<Width>(value.of + at); };
  const Real length = StrandLanes::step_in_reach * of(lanes.reach);
  const Real along = of(lanes.along) * length;
  Vector<Real> turn[5];
  for (int i = 0; i < 5; ++i)
    turn[i] =
        stepped<Width>(load_vector<Width>(lanes.turn[i], at), along * of(lanes.tangent[i]) + of(lanes.correction[i]));
  // Of the arc sine as much as it takes to tell one whole turn from the next.
  const Real sine = cross(load_vector<Width>(lanes.turn[0], at), turn[0]), z = sine * sine;
  store<Width>(of(lanes.turned) + sine * (1.0 + z * (1.0 / 6 + z * (3.0 / 40))), lanes.turned.of + at);
  const StrandBall<Width> ball = strand_ball<Width>(terms_at<Width>(lanes, at, turn));
  Mask dead = negated<Width>(less<Width>(Real{}, ball.tangent[0] * of(lanes.home_sign)));
  const Mask lost = negated<Width>(less<Width>(of(lanes.least_reach), ball.reach));
  dead &= negated<Width>(lost);
  const Real reach_square = ball.reach * ball.reach;
  Mask near = 0;
  for (const auto& place : lanes.place) near |= less<Width>(chords<Width>(place, at, turn), reach_square);
  for (int i = 0; i < 5; ++i) {
    store_vector<Width>(turn[i], lanes.turn[i], at);
    store<Width>(ball.tangent[i], lanes.tangent[i].of + at);
    store<Width>(ball.correction[i], lanes.correction[i].of + at);
  }
  store<Width>(ball.reach, lanes.reach.of + at);
  store<Width>(of(lanes.length) + length, lanes.length.of + at);
  const Real least = of(lanes.least_sine_4th);
  store<Width>(select<Width>(dead | lost, least, smaller(ball.sine_4th, least)), lanes.least_sine_4th.of + at);

  bool any = false;
  for (int lane = 0; lane < Width; ++lane) {
    const Mask bit = 1u << lane;
    const int i = at + lane;
    ++lanes.steps[i];
    lanes.event[i] = lanes.idle[i]                              ? TravelEvent::none
                     : lost & bit                               ? TravelEvent::undecided
                     : dead & bit                               ? TravelEvent::dead_point
                     : near & bit                               ? TravelEvent::arrived
                     : lanes.steps[i] > StrandLanes::most_steps ? TravelEvent::undecided
                                                                : TravelEvent::none;
    any = any || lanes.event[i] != TravelEvent::none;
  }
  return any;
}

template <int Width>
void strand_kernel(StrandLanes& lanes) {
  for (bool any = false; !any;)
    for (int at = 0; at < six_bar_lanes; at += Width) any = strands_step<Width>(lanes, at) || any;
}

}  // namespace linkwright::LINKWRIGHT_ISA
