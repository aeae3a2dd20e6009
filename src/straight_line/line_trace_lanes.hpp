#pragma once

// The path of a point beside its tangent, a linkage to each lane, for maps: quick, and good to rank. Included by the
// line_trace_kernel_*.cpp files, one for each instruction set. First the series of the loop (as loop_series() has it,
// to the seventh power), which says how far the first terms carry; then steps of one link's turn that long, the other
// two links by the intersection of two circles.

#include "core/pack_vector.hpp"
#include "straight_line/line_trace_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::line_trace {

template <int Width>
using Real = typename Pack<Width>::Real;

inline constexpr int order = 7;

/// The links as they lie; input + coupler + output = ground, `arm` from the input's moving pivot to the point, which is
/// coupler · arm_in_coupler.
template <class R>
struct Linkage {
  Vector<R> input, coupler, output, ground, arm, arm_in_coupler, line;
};

template <int Width>
LINKWRIGHT_INLINE Linkage<Real<Width>> linkage_in(const LineTraceBlock& block, int lane) {
  using R = Real<Width>;
  const auto at = [&](const double(&numbers)[2][LineTraceBlock::size]) {
    return Vector<R>{load<Width>(numbers[0] + lane), load<Width>(numbers[1] + lane)};
  };
  const Vector<R> a0 = at(block.input_center), a = at(block.input_circle), b0 = at(block.output_center),
                  b = at(block.output_circle);
  const Vector<R> coupler = b - a, arm = at(block.point) - a;
  const R square = dot(coupler, coupler);
  return {a - a0,
          coupler,
          b0 - b,
          b0 - a0,
          arm,
          {dot(arm, coupler) / square, cross(coupler, arm) / square},
          {R{} + block.direction[0], R{} + block.direction[1]}};
}

/// How the point leaves the line, and the turns of input and coupler by the way along it.
template <class R>
struct Beginning {
  R along[order + 1], off[order + 1];  ///< by the parameter of the loop
  R input_turn, coupler_turn;          ///< first derivatives
};

template <int Width>
LINKWRIGHT_INLINE Beginning<Real<Width>> beginning(const Linkage<Real<Width>>& linkage) {
  using R = Real<Width>;
  const Vector<R> links[3] = {linkage.input, linkage.coupler, linkage.output};
  const R way[3] = {cross(links[1], links[2]), cross(links[2], links[0]), cross(links[0], links[1])};
  const R square = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
  const R unit = 1.0 / square_root<Width>(square);
  // (−x_sum, y_sum) times these are the shortest corrections of the turns.
  R by_x[3], by_y[3];
  for (int j = 0; j < 3; ++j) {
    const int next = (j + 1) % 3, last = (j + 2) % 3;
    by_y[j] = (links[next].y * way[last] - links[last].y * way[next]) / square;
    by_x[j] = (way[next] * links[last].x - way[last] * links[next].x) / square;
  }
  R turn[3][order + 1];
  Vector<R> rotation[3][order + 1];
  for (int j = 0; j < 3; ++j) {
    rotation[j][0] = {R{} + 1.0, R{}};
    turn[j][1] = way[j] * unit;
    rotation[j][1] = {R{}, turn[j][1]};
  }
  for (int k = 2; k <= order; ++k) {
    Vector<R> known[3], sum = {R{}, R{}};
    for (int j = 0; j < 3; ++j) {
      Vector<R> terms = {R{}, R{}};
      for (int i = 1; i < k; ++i) terms = terms + (static_cast<double>(i) * turn[j][i]) * rotation[j][k - i];
      known[j] = {-terms.y / static_cast<double>(k), terms.x / static_cast<double>(k)};
      sum = sum + product(links[j], known[j]);
    }
    for (int j = 0; j < 3; ++j) {
      turn[j][k] = sum.x * by_x[j] - sum.y * by_y[j];
      rotation[j][k] = {known[j].x, known[j].y + turn[j][k]};
    }
  }
  Beginning<R> begins;
  for (int k = 1; k <= order; ++k) {
    const Vector<R> path = product(linkage.input, rotation[0][k]) + product(linkage.arm, rotation[1][k]);
    begins.along[k] = dot(linkage.line, path);
    begins.off[k] = cross(linkage.line, path);
  }
  begins.input_turn = turn[0][1];
  begins.coupler_turn = turn[1][1];
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

template <class R>
struct Place {
  R s, e, sine_square, velocity;
};

/// The other two links where one, `drive`, is turned: first + second = ground − drive.
template <int Width>
struct Closure {
  using R = Real<Width>;
  R first_square, difference, side;

  LINKWRIGHT_INLINE Closure(Vector<R> first, Vector<R> second)
      : first_square(dot(first, first)),
        difference(dot(first, first) - dot(second, second)),
        side(with_sign_of<Width>(R{} + 1.0, cross(first + second, first))) {}

  /// `open`: lanes in which the links reach each other.
  LINKWRIGHT_INLINE Vector<R> first_at(Vector<R> rest, Mask& open) const {
    const R square = dot(rest, rest);
    const R along = (square + difference) / (2.0 * square);
    const R height = first_square / square - along * along;
    open &= less<Width>(R{}, height);
    const R across = side * square_root<Width>(larger<R>(height, R{}));
    return {along * rest.x - across * rest.y, along * rest.y + across * rest.x};
  }
};

template <int Width>
LINKWRIGHT_INLINE Place<Real<Width>> place_of(const Linkage<Real<Width>>& start, Vector<Real<Width>> input,
                                              Vector<Real<Width>> coupler) {
  using R = Real<Width>;
  const Vector<R> output = start.ground - input - coupler, arm = product(coupler, start.arm_in_coupler);
  const Vector<R> moved = input + arm - start.input - start.arm;
  const R sine = cross(coupler, output), input_rate = -cross(output, coupler), coupler_rate = cross(output, input);
  // i Σ zⱼ fⱼ = 0 crossed with the output: the rates of input and coupler but for a common factor.
  const Vector<R> rate = input_rate * input + coupler_rate * arm;
  return {dot(start.line, moved), cross(start.line, moved), sine * sine / (dot(coupler, coupler) * dot(output, output)),
          -cross(start.line, rate) / input_rate};
}

template <int Width, bool by_input>
LINKWRIGHT_INLINE void walk(LineTraceBlock& block, int lane, const Linkage<Real<Width>>& start,
                            const Beginning<Real<Width>>& begins, Real<Width> step, Real<Width> deviation, int sense) {
  using R = Real<Width>;
  const Vector<R>& drive = by_input ? start.input : start.coupler;
  const Vector<R>& first = by_input ? start.coupler : start.input;
  const Closure<Width> closure(first, start.output);
  // Towards rising or falling s.
  const R turn = by_input ? begins.input_turn : begins.coupler_turn;
  const R towards =
      with_sign_of<Width>(R{} + static_cast<double>(sense), turn * begins.along[1] * static_cast<double>(sense));
  const auto turned = sine_cosine<Width>(towards * step);
  Vector<R> rotor = {turned.cosine, turned.sine}, driven = drive;
  R before = R{};
  Mask on = all_lanes<Width>;
  int last[Width] = {};
  const R enough = R{} + block.half_stroke, off = 2.0 * deviation;
  for (int i = 1; i <= LineTraceBlock::steps && on != 0; ++i) {
    if (i == 17 || i == 23) rotor = product(rotor, rotor);
    driven = product(driven, rotor);
    Mask open = on;
    const Vector<R> other = closure.first_at(start.ground - driven, open);
    const Place<R> place = by_input ? place_of<Width>(start, driven, other) : place_of<Width>(start, other, driven);
    const R ahead = static_cast<double>(sense) * place.s;
    on = open & less<Width>(before, ahead);
    before = ahead;
    const int row = LineTraceBlock::steps + sense * i;
    store<Width>(place.s, block.s[row] + lane);
    store<Width>(place.e, block.e[row] + lane);
    store<Width>(place.sine_square, block.sine_square[row] + lane);
    store<Width>(place.velocity, block.velocity[row] + lane);
    for (int k = 0; k < Width; ++k) last[k] += static_cast<int>(on >> k & 1);
    on &= less<Width>(magnitude<Width>(place.e), off) | less<Width>(ahead, enough);
  }
  for (int k = 0; k < Width; ++k)
    (sense > 0 ? block.last : block.first)[lane + k] =
        static_cast<unsigned char>(LineTraceBlock::steps + sense * last[k]);
}

template <int Width, bool by_input>
LINKWRIGHT_INLINE void trace(LineTraceBlock& block, int lane) {
  using R = Real<Width>;
  constexpr double longest_step = 0.05, steps_to_deviation = 12;
  const Linkage<R> start = linkage_in<Width>(block, lane);
  const Beginning<R> begins = beginning<Width>(start);
  const R deviation = load<Width>(block.deviation + lane);
  R power = begins.along[1];
  for (int k = 1; k < block.contact; ++k) power = power * begins.along[1];
  store<Width>(begins.off[block.contact] / power, block.coefficient + lane);
  const R rate = magnitude<Width>(by_input ? begins.input_turn : begins.coupler_turn);
  const R wanted =
      smaller<R>(reach<Width>(begins, deviation, block.contact) * rate, R{} + steps_to_deviation * longest_step) /
      steps_to_deviation;
  // The stroke that is asked for takes half of the short steps at least.
  const R stroke = block.half_stroke / magnitude<Width>(begins.along[1]) * rate / 16.0;
  const R step = smaller<R>(larger<R>(wanted, stroke), R{} + longest_step);
  constexpr int middle = LineTraceBlock::steps;
  const Place<R> here = place_of<Width>(start, start.input, start.coupler);
  store<Width>(R{}, block.s[middle] + lane);
  store<Width>(R{}, block.e[middle] + lane);
  store<Width>(here.sine_square, block.sine_square[middle] + lane);
  store<Width>(here.velocity, block.velocity[middle] + lane);
  walk<Width, by_input>(block, lane, start, begins, step, deviation, 1);
  walk<Width, by_input>(block, lane, start, begins, step, deviation, -1);
}

template <int Width>
LINKWRIGHT_INLINE void line_trace_kernel(LineTraceBlock& block) {
  for (int lane = 0; lane < LineTraceBlock::size; lane += Width)
    block.by_input ? trace<Width, true>(block, lane) : trace<Width, false>(block, lane);
}

}  // namespace linkwright::LINKWRIGHT_ISA::line_trace
