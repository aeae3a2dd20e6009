#pragma once

// The path of a point beside its tangent, a linkage to each lane, for maps: quick, and good to rank. Included by the
// line_trace_kernel_*.cpp files, one for each instruction set. First the series of the loop (as loop_series() has it,
// to the seventh power), which says how far the first terms carry; then steps along the curve on which the loop stays
// closed, by the turns of all three links: it runs on smoothly where any one of them is at its dead point.

#include "core/pack_vector.hpp"
#include "straight_line/line_trace_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::line_trace {

template <int Width>
using Real = typename Pack<Width>::Real;

inline constexpr int order = 7;

/// Input, coupler and output as they lie: input + coupler + output = ground.
template <class R>
struct Links {
  Vector<R> link[3];
};

/// `arm` from the input's moving pivot to the point, which is coupler · arm_in_coupler.
template <class R>
struct Linkage {
  Links<R> links;
  Vector<R> ground, arm, arm_in_coupler, line;
  R over_lengths;  ///< 1 / (coupler · output)
};

template <int Width>
LINKWRIGHT_INLINE Linkage<Real<Width>> linkage_in(const LineTraceBlock& block, int lane) {
  using R = Real<Width>;
  const auto at = [&](const double(&numbers)[2][LineTraceBlock::size]) {
    return Vector<R>{load<Width>(numbers[0] + lane), load<Width>(numbers[1] + lane)};
  };
  const Vector<R> a0 = at(block.input_fixed), a = at(block.input_moving), b0 = at(block.output_fixed),
                  b = at(block.output_moving);
  const Vector<R> coupler = b - a, output = b0 - b, arm = at(block.point) - a;
  const R square = dot(coupler, coupler);
  return {{{a - a0, coupler, output}},
          b0 - a0,
          arm,
          {dot(arm, coupler) / square, cross(coupler, arm) / square},
          {R{} + block.direction[0], R{} + block.direction[1]},
          1.0 / square_root<Width>(square * dot(output, output))};
}

/// How the links turn together: along `way`, of unit length, the loop stays closed; (−x, y) of what is missing times
/// `by_x` and `by_y` are the shortest turns that close it.
template <class R>
struct Turning {
  R way[3], by_x[3], by_y[3];

  LINKWRIGHT_INLINE R correction(int j, Vector<R> gap) const { return gap.y * by_y[j] - gap.x * by_x[j]; }
};

template <int Width>
LINKWRIGHT_INLINE Turning<Real<Width>> turning_of(const Links<Real<Width>>& of) {
  using R = Real<Width>;
  const auto& link = of.link;
  R way[3];
  for (int j = 0; j < 3; ++j) way[j] = cross(link[(j + 1) % 3], link[(j + 2) % 3]);
  const R unit = 1.0 / square_root<Width>(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
  Turning<R> turning;
  for (int j = 0; j < 3; ++j) turning.way[j] = way[j] * unit;
  for (int j = 0; j < 3; ++j) {
    const int next = (j + 1) % 3, last = (j + 2) % 3;
    turning.by_y[j] = unit * (link[next].y * turning.way[last] - link[last].y * turning.way[next]);
    turning.by_x[j] = unit * (turning.way[next] * link[last].x - turning.way[last] * link[next].x);
  }
  return turning;
}

/// How the point leaves the line, and how the links set out.
template <class R>
struct Beginning {
  R along[order + 1], off[order + 1];  ///< by the parameter of the loop
  R way[3], bend[3];                   ///< of the turns: first and second derivatives
};

template <int Width>
LINKWRIGHT_INLINE Beginning<Real<Width>> beginning(const Linkage<Real<Width>>& linkage) {
  using R = Real<Width>;
  const auto& links = linkage.links.link;
  const Turning<R> turning = turning_of<Width>(linkage.links);
  R turn[3][order + 1];
  Vector<R> rotation[3][order + 1];
  for (int j = 0; j < 3; ++j) {
    rotation[j][0] = {R{} + 1.0, R{}};
    turn[j][1] = turning.way[j];
    rotation[j][1] = {R{}, turn[j][1]};
  }
  for (int k = 2; k <= order; ++k) {
    Vector<R> known[3], sum = {R{}, R{}};
    for (int j = 0; j < 3; ++j) {
      Vector<R> terms = {R{}, R{}};
      for (int i = 1; i < k; ++i) terms = terms + (static_cast<double>(i) * turn[j][i]) * rotation[j][k - i];
      known[j] = {-terms.y / static_cast<double>(k), terms.x / static_cast<double>(k)};
      sum = sum - product(links[j], known[j]);
    }
    for (int j = 0; j < 3; ++j) {
      turn[j][k] = turning.correction(j, sum);
      rotation[j][k] = {known[j].x, known[j].y + turn[j][k]};
    }
  }
  Beginning<R> begins;
  for (int k = 1; k <= order; ++k) {
    const Vector<R> path = product(links[0], rotation[0][k]) + product(linkage.arm, rotation[1][k]);
    begins.along[k] = dot(linkage.line, path);
    begins.off[k] = cross(linkage.line, path);
  }
  for (int j = 0; j < 3; ++j) {
    begins.way[j] = turn[j][1];
    begins.bend[j] = 2.0 * turn[j][2];
  }
  return begins;
}

/// Within some 5 %, for a > 0: by a share of the bits, which grow about as the logarithm does.
template <int Width>
LINKWRIGHT_INLINE Real<Width> root_estimate(Real<Width> a, double degree) {
  using Integer = typename Pack<Width>::Integer;
  constexpr double bits_of_one = 0x3ff0'0000p32;
  const double rest = bits_of_one * (1 - 1 / degree);
  if constexpr (Width == 1) {
    return __builtin_bit_cast(
        Real<Width>, static_cast<Integer>(static_cast<double>(__builtin_bit_cast(Integer, a)) / degree + rest));
  } else {
    const Real<Width> bits = __builtin_convertvector(__builtin_bit_cast(Integer, a), Real<Width>);
    return __builtin_bit_cast(Real<Width>, __builtin_convertvector(bits / degree + rest, Integer));
  }
}

/// The turn over which each term of the deviation alone would reach δ, the least of them.
template <int Width>
LINKWRIGHT_INLINE Real<Width> reach(const Beginning<Real<Width>>& begins, Real<Width> deviation, int contact) {
  using R = Real<Width>;
  R least = R{} + 1e300;
  for (int k = contact; k <= order; ++k) {
    const R share = deviation / larger<R>(magnitude<Width>(begins.off[k]), R{} + 1e-300);
    least = smaller<R>(least, root_estimate<Width>(smaller<R>(share, R{} + 1e200), static_cast<double>(k)));
  }
  return least;
}

/// Turned by a small angle; beyond half a radian it is not unit any more.
template <class R>
LINKWRIGHT_INLINE Vector<R> turned(Vector<R> link, R angle) {
  const R square = angle * angle;
  const R cosine = 1.0 - square * (0.5 - square * (1.0 / 24 - square * (1.0 / 720 - square / 40320.0)));
  const R sine = angle * (1.0 - square * (1.0 / 6 - square * (1.0 / 120 - square * (1.0 / 5040 - square / 362880.0))));
  return product(link, Vector<R>{cosine, sine});
}

template <class R>
struct Place {
  R s, e, turn;     ///< of the input
  R ds, de, dturn;  ///< by the way of the turns
  R sine;           ///< of the transmission angle, signed
};

template <int Width>
LINKWRIGHT_INLINE Place<Real<Width>> place_of(const Linkage<Real<Width>>& start, const Links<Real<Width>>& links,
                                              const Real<Width> (&way)[3], Real<Width> turn) {
  using R = Real<Width>;
  const auto& [input, coupler, output] = links.link;
  const Vector<R> arm = product(coupler, start.arm_in_coupler);
  const Vector<R> moved = input + arm - start.links.link[0] - start.arm;
  const Vector<R> rate = way[0] * input + way[1] * arm;  // a quarter turn ahead of it the point moves
  return {dot(start.line, moved),
          cross(start.line, moved),
          turn,
          -cross(start.line, rate),
          dot(start.line, rate),
          way[0],
          start.over_lengths * cross(coupler, output)};
}

/// Where the point turns back between two places a step apart: there ds vanishes.
template <int Width>
LINKWRIGHT_INLINE Place<Real<Width>> turning_place(const Place<Real<Width>>& a, const Place<Real<Width>>& b,
                                                   Real<Width> step, Real<Width> share) {
  using R = Real<Width>;
  const R rest = 1.0 - share;
  const auto cubic = [&](R from, R to, R slope_from, R slope_to) {
    return rest * rest * ((1.0 + 2.0 * share) * from + share * step * slope_from) +
           share * share * ((1.0 + 2.0 * rest) * to - rest * step * slope_to);
  };
  const auto between = [&](R from, R to) { return rest * from + share * to; };
  return {cubic(a.s, b.s, a.ds, b.ds),
          cubic(a.e, b.e, a.de, b.de),
          cubic(a.turn, b.turn, a.dturn, b.dturn),
          R{},
          between(a.de, b.de),
          between(a.dturn, b.dturn),
          between(a.sine, b.sine)};
}

template <int Width>
LINKWRIGHT_INLINE void put(LineTraceBlock& block, int row, int lane, const Place<Real<Width>>& place) {
  store<Width>(place.s, block.s[row] + lane);
  store<Width>(place.e, block.e[row] + lane);
  store<Width>(place.turn, block.turn[row] + lane);
  store<Width>(place.ds, block.ds[row] + lane);
  store<Width>(place.de, block.de[row] + lane);
  store<Width>(place.dturn, block.dturn[row] + lane);
  store<Width>(place.sine, block.sine[row] + lane);
}

/// From a place on, by steps that grow. The way of the turns is known, how it bends from the step before: so the loop
/// is closed but for the third power of the step, and two corrections leave nothing of that.
template <int Width>
struct Walk {
  using R = Real<Width>;
  const Linkage<R>& start;
  Links<R> links;
  R way[3], bend[3];  ///< of unit length
  R onward;           ///< ±1: the sense in which the walk runs along turning_of()
  R step, input_turn;

  /// Lanes in which the loop is closed well enough for deviations of this size, and the way did not swing round.
  LINKWRIGHT_INLINE Mask go(R deviation) {
    Links<R> next;
    const auto ahead = [&](int j) { return step * (way[j] + 0.5 * step * bend[j]); };
    for (int j = 0; j < 3; ++j) next.link[j] = turned<R>(links.link[j], ahead(j));
    input_turn = input_turn + ahead(0);
    const Turning<R> turning = turning_of<Width>(next);
    Vector<R> gap;
    for (int turn = 0; turn < 2; ++turn) {
      gap = start.ground - next.link[0] - next.link[1] - next.link[2];
      for (int j = 0; j < 3; ++j) next.link[j] = turned<R>(next.link[j], turning.correction(j, gap));
      input_turn = input_turn + turning.correction(0, gap);
    }
    R swung = R{};
    for (int j = 0; j < 3; ++j) {
      const R there = onward * turning.way[j], change = there - way[j];
      swung = swung + change * change;
      bend[j] = change / step;
      way[j] = there;
    }
    links = next;
    constexpr double left = 0.1;        // of the deviation, before the last correction
    constexpr double most_swung = 0.5;  // of the way, in radians: next to a change point it may end on the other branch
    return less<Width>(dot(gap, gap), left * left * deviation * deviation) &
           less<Width>(swung, R{} + most_swung * most_swung);
  }
  /// By a shorter step where one is too long, so many times.
  LINKWRIGHT_INLINE Mask go_carefully(R deviation, Mask on, int tries) {
    constexpr double shorter = 0.3;
    for (; tries > 1; --tries) {
      Walk trial = *this;
      const Mask too_long = on & negated<Width>(trial.go(deviation));
      if (too_long == 0) break;
      step = select<Width>(too_long, shorter * step, step);
    }
    return go(deviation);
  }
  /// The longer the way behind, the longer the step; where it bends, none that turns it by much.
  LINKWRIGHT_INLINE void lengthen(double growth) {
    constexpr double longest = 0.08, most_turned = 0.1;
    const R square = bend[0] * bend[0] + bend[1] * bend[1] + bend[2] * bend[2];
    const R grown = smaller<R>(growth * step, R{} + longest);
    step = select<Width>(less<Width>(R{} + most_turned * most_turned, step * step * square), 0.6 * step, grown);
  }
};

template <int Width>
LINKWRIGHT_INLINE void walk(LineTraceBlock& block, int lane, const Linkage<Real<Width>>& start,
                            const Beginning<Real<Width>>& begins, Real<Width> step, Real<Width> deviation, int sense,
                            const Place<Real<Width>>& here, Mask& doubtful) {
  using R = Real<Width>;
  const R onward = with_sign_of<Width>(R{} + static_cast<double>(sense), begins.along[1] * static_cast<double>(sense));
  Walk<Width> along{start, start.links, {}, {}, onward, step, R{}};
  for (int j = 0; j < 3; ++j) {
    along.way[j] = onward * begins.way[j];
    along.bend[j] = begins.bend[j];
  }
  Place<R> before = here;
  Mask on = all_lanes<Width>;
  int last[Width] = {};
  const R enough = R{} + block.half_stroke, off = 2.0 * deviation;
  for (int i = 1; i <= block.steps && on != 0; ++i) {
    doubtful |= on & negated<Width>(along.go_carefully(deviation, on, block.tries));
    const R length = along.step;
    Place<R> place = place_of<Width>(start, along.links, along.way, along.input_turn);
    for (R* slope : {&place.ds, &place.de, &place.dturn}) *slope = static_cast<double>(sense) * *slope;  // by rising s
    const Mask ahead = less<Width>(R{}, place.ds);
    const R share = select<Width>(ahead, R{} + 1.0, before.ds / (before.ds - place.ds));
    const Place<R> turn = turning_place<Width>(before, place, static_cast<double>(sense) * length, share);
    const auto chosen = [&](R goes_on, R turns) { return select<Width>(ahead, goes_on, turns); };
    place = {chosen(place.s, turn.s),      chosen(place.e, turn.e),   chosen(place.turn, turn.turn),
             chosen(place.ds, turn.ds),    chosen(place.de, turn.de), chosen(place.dturn, turn.dturn),
             chosen(place.sine, turn.sine)};
    doubtful |= on & negated<Width>(less<Width>(R{}, static_cast<double>(sense) * (place.s - before.s)));
    const int row = LineTraceBlock::most_steps + sense * i;
    put<Width>(block, row, lane, place);
    store<Width>(share * length, block.step[row] + lane);
    for (int k = 0; k < Width; ++k) last[k] += static_cast<int>(on >> k & 1);
    on &= ahead & (less<Width>(magnitude<Width>(place.e), off) | less<Width>(magnitude<Width>(place.s), enough));
    before = place;
    along.lengthen(block.growth);
  }
  doubtful |= on;  // the path goes on
  for (int k = 0; k < Width; ++k)
    (sense > 0 ? block.last : block.first)[lane + k] = static_cast<short>(LineTraceBlock::most_steps + sense * last[k]);
}

template <int Width>
LINKWRIGHT_INLINE void trace(LineTraceBlock& block, int lane) {
  using R = Real<Width>;
  constexpr double longest_step = 0.05, steps_to_deviation = 12;
  const Linkage<R> start = linkage_in<Width>(block, lane);
  const Beginning<R> begins = beginning<Width>(start);
  const R deviation = load<Width>(block.deviation + lane);
  R power = begins.along[1];
  for (int k = 1; k < block.contact; ++k) power = power * begins.along[1];
  store<Width>(begins.off[block.contact] / power, block.coefficient + lane);
  const R step = smaller<R>(reach<Width>(begins, deviation, block.contact), R{} + steps_to_deviation * longest_step) /
                 steps_to_deviation;
  Place<R> here = place_of<Width>(start, start.links, begins.way, R{});
  const R rises = with_sign_of<Width>(R{} + 1.0, here.ds);
  for (R* slope : {&here.ds, &here.de, &here.dturn}) *slope = rises * *slope;
  here.s = here.e = R{};
  put<Width>(block, LineTraceBlock::most_steps, lane, here);
  Mask doubtful = 0;
  walk<Width>(block, lane, start, begins, step, deviation, 1, here, doubtful);
  walk<Width>(block, lane, start, begins, step, deviation, -1, here, doubtful);
  for (int k = 0; k < Width; ++k) block.doubtful[lane + k] = (doubtful >> k & 1) != 0;
}

template <int Width>
LINKWRIGHT_INLINE void line_trace_kernel(LineTraceBlock& block) {
  for (int lane = 0; lane < static_cast<int>(LineTraceBlock::size); lane += Width) trace<Width>(block, lane);
}

}  // namespace linkwright::LINKWRIGHT_ISA::line_trace
