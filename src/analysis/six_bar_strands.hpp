#pragma once

// Six-bars on their way along their curves of configurations, one to each lane. Included by the six_bar_kernel_*.cpp
// files, one for each instruction set.

#include "analysis/six_bar_lanes.hpp"
#include "analysis/six_bar_strand.hpp"

namespace linkwright::LINKWRIGHT_ISA {

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
