#pragma once

// Six-bars in dyads on their way, one to each lane: steps of the driver between which no dead point can hide. Included
// by the six_bar_kernel_*.cpp files, one for each instruction set. docs/theory/six-bars.md, section 4, derives the
// bounds.

#include "six_bar_lanes.hpp"

namespace linkwright::LINKWRIGHT_ISA {

inline constexpr double longest_step = 0.5, shortest_step = 1e-7;

template <int Width, class Real = typename Pack<Width>::Real>
LINKWRIGHT_INLINE Vector<Real> select(Mask mask, Vector<Real> yes, Vector<Real> no) {
  return {select<Width>(mask, yes.x, no.x), select<Width>(mask, yes.y, no.y)};
}

/// What both dyads are like at a turn of the driver.
template <int Width>
struct DyadsAt {
  using Real = typename Pack<Width>::Real;
  Real cosine, cosine_rate;
  Vector<Real> w;
  Real ww;
  Real sine_square[2];  ///< negative where the dyad does not reach

  /// `of`: EachLane or OneLane.
  template <class Reader>
  LINKWRIGHT_INLINE DyadsAt(const DyadLanes& lanes, Reader of, Vector<Real> turn) {
    const Vector<Real> arm = product(of(lanes.c1), turn), u = of(lanes.c0) + arm;
    const Real xx = of(lanes.xx), yy = of(lanes.yy), uu = dot(u, u), p = uu + (xx - yy);
    const Real four_areas_square = 4.0 * xx * uu - p * p;
    const Real root = of(lanes.side) * square_root<Width>(larger(four_areas_square, Real{}));
    const Real half = 0.5 / uu;
    const Vector<Real> x = {half * (-p * u.x - root * u.y), half * (root * u.x - p * u.y)};
    const Vector<Real> y = {-u.x - x.x, -u.y - x.y};
    w = of(lanes.d0) + product(of(lanes.d1), turn) + product(of(lanes.gx), x) + product(of(lanes.gy), y);
    ww = dot(w, w);
    const Real per = of(lanes.per_two_xy);
    cosine = (uu - (xx + yy)) * per;
    cosine_rate = magnitude<Width>(2.0 * cross(u, arm) * per);
    const Real other_cosine = (ww - of(lanes.pp_and_qq)) / of(lanes.two_pq);
    sine_square[0] = 1.0 - cosine * cosine;
    sine_square[1] = 1.0 - other_cosine * other_cosine;
  }
};

/// Lanes in which both dyads reach all the way over a step of at most `angle` from where the lanes are to `next`.
template <int Width>
LINKWRIGHT_INLINE Mask reach_all_the_way(const DyadLanes& lanes, int at, typename Pack<Width>::Real angle,
                                         const DyadsAt<Width>& next) {
  using Real = typename Pack<Width>::Real;
  const EachLane<Width> of{at};
  const Real cosine =
      magnitude<Width>(of(lanes.cosine)) + angle * (of(lanes.cosine_rate) + 0.5 * angle * of(lanes.bend_of_u));
  const Real per_sine_square = 1.0 / larger(1.0 - cosine * cosine, Real{} + 1e-300);
  const Real per_sine = square_root<Width>(per_sine_square);
  const Real bend = of(lanes.bend) + of(lanes.first_bend) * per_sine_square +
                    of(lanes.second_bend) * ((of(lanes.turned) + of(lanes.slope) * per_sine_square) * per_sine);
  const Real off_chord = 0.125 * angle * angle * bend;
  const Real here = of(lanes.ww);
  const Vector<Real> chord = next.w - load_vector<Width>(lanes.w, at);
  const Real farthest = square_root<Width>(larger(here, next.ww)) + off_chord;
  const Real nearest_square = smaller(here, next.ww) - 0.25 * dot(chord, chord);
  const Real nearest = square_root<Width>(larger(nearest_square, Real{})) - off_chord;
  return less<Width>(cosine, 1.0 + of(lanes.beyond_reach[0])) & less<Width>(farthest, of(lanes.longest)) &
         less<Width>(of(lanes.shortest), nearest);
}

template <int Width>
LINKWRIGHT_INLINE void commit(DyadLanes& lanes, int at, Mask done, const DyadsAt<Width>& next,
                              Vector<typename Pack<Width>::Real> turn) {
  const auto put = [at, done](const auto& value, LaneReal& to) {
    store<Width>(select<Width>(done, value, load<Width>(to.of + at)), to.of + at);
  };
  put(turn.x, lanes.turn.x);
  put(turn.y, lanes.turn.y);
  put(next.cosine, lanes.cosine);
  put(next.cosine_rate, lanes.cosine_rate);
  put(next.w.x, lanes.w.x);
  put(next.w.y, lanes.w.y);
  put(next.ww, lanes.ww);
  double x[Width], y[Width], first[Width], second[Width];
  store<Width>(turn.x, x);
  store<Width>(turn.y, y);
  store<Width>(next.sine_square[0], first);
  store<Width>(next.sine_square[1], second);
  for (int lane = 0; lane < Width; ++lane) {
    if (!(done >> lane & 1)) continue;
    const int i = at + lane, sample = lanes.samples[i]++;
    lanes.passed[sample].x.of[i] = x[lane];
    lanes.passed[sample].y.of[i] = y[lane];
    lanes.sine_squares[0][sample].of[i] = first[lane];
    lanes.sine_squares[1][sample].of[i] = second[lane];
  }
}

/// One step of `Width` lanes; whether any of them came to an event.
template <int Width>
LINKWRIGHT_INLINE bool dyads_step(DyadLanes& lanes, int at) {
  using Real = typename Pack<Width>::Real;
  const Vector<Real> turn = load_vector<Width>(lanes.turn, at), goal = load_vector<Width>(lanes.goal, at);
  const Real sense = load<Width>(lanes.sense.of + at), wanted = load<Width>(lanes.step.of + at);
  const Real along = dot(turn, goal), across = sense * cross(turn, goal);
  const Real rest = 2.0 * across / (1.0 + along);
  const Mask arrives =
      less<Width>(Real{}, along) & less<Width>(Real{}, across) & less<Width>((1.0 - 1e-9) * rest, wanted);
  const Real step = select<Width>(arrives, rest, wanted);
  const Real q = 0.25 * step * step, per = 1.0 / (1.0 + q);
  const Vector<Real> rotation = {(1.0 - q) * per, sense * step * per};
  Vector<Real> ahead = product(turn, rotation);
  ahead = 0.5 * (3.0 - dot(ahead, ahead)) * ahead;  // rounding must not add up
  ahead = select<Width>(arrives, goal, ahead);

  const DyadsAt<Width> next(lanes, EachLane<Width>{at}, ahead);
  const Mask dead = less<Width>(next.sine_square[0], load<Width>(lanes.beyond_reach[0].of + at)) |
                    (less<Width>(Real{}, next.sine_square[0]) &
                     less<Width>(next.sine_square[1], load<Width>(lanes.beyond_reach[1].of + at)));
  const Mask done = reach_all_the_way<Width>(lanes, at, step, next) & negated<Width>(dead);
  const Real next_step = select<Width>(done, smaller(1.6 * step, Real{} + longest_step), 0.5 * step);
  store<Width>(next_step, lanes.step.of + at);
  commit<Width>(lanes, at, done, next, ahead);

  const Mask too_short = less<Width>(next_step, Real{} + shortest_step) & negated<Width>(done);
  bool any = false;
  for (int lane = 0; lane < Width; ++lane) {
    const int i = at + lane;
    if (lanes.idle[i]) {
      lanes.samples[i] = 0;
      continue;
    }
    const Mask bit = 1u << lane;
    TravelEvent event = TravelEvent::none;
    if (dead & bit)
      event = TravelEvent::dead_point;
    else if (done & arrives & bit)
      event = TravelEvent::arrived;
    else if (too_short & bit)
      event = TravelEvent::undecided;
    else if (lanes.samples[i] + 1 >= DyadLanes::most_samples)
      event = TravelEvent::full;
    lanes.event[i] = event;
    any = any || event != TravelEvent::none;
  }
  return any;
}

template <int Width>
void dyad_kernel(DyadLanes& lanes) {
  for (bool any = false; !any;)
    for (int at = 0; at < six_bar_lanes; at += Width) any = dyads_step<Width>(lanes, at) || any;
}

/// The squared sines halfway between the samples of one lane.
template <int Width>
void dyad_middles_kernel(DyadMiddles& middles) {
  using Real = typename Pack<Width>::Real;
  const DyadLanes& lanes = *middles.lanes;
  const int gaps = lanes.samples[middles.lane] - 1;
  for (int first = 0; first < gaps; first += Width) {
    double x[2][Width], y[2][Width], squares[2][Width];
    for (int k = 0; k < Width; ++k)
      for (int end = 0; end < 2; ++end) {
        const LaneVector& turn = lanes.passed[(first + k < gaps ? first + k : gaps - 1) + end];
        x[end][k] = turn.x.of[middles.lane];
        y[end][k] = turn.y.of[middles.lane];
      }
    const Vector<Real> here = {load<Width>(x[0]), load<Width>(y[0])}, next = {load<Width>(x[1]), load<Width>(y[1])};
    const Real half = cross(here, next) / (1.0 + dot(here, next)), q = 0.25 * half * half, per = 1.0 / (1.0 + q);
    const DyadsAt<Width> middle(lanes, OneLane<Width>{middles.lane}, product(here, {(1.0 - q) * per, half * per}));
    for (int dyad = 0; dyad < 2; ++dyad) {
      store<Width>(middle.sine_square[dyad], squares[dyad]);
      for (int k = 0; k < Width && first + k < gaps; ++k) middles.sine_squares[dyad][first + k] = squares[dyad][k];
    }
  }
}

}  // namespace linkwright::LINKWRIGHT_ISA
