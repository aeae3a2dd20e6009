#pragma once

// The distance of the best coupler point, a shape of a four-bar to each lane. Included by the timed_scan_kernel_*.cpp
// files, one for each instruction set.

#include "approximate/timed_scan_kernel.hpp"
#include "core/pack_vector.hpp"

namespace linkwright::LINKWRIGHT_ISA {

template <int Width>
using TimedReal = typename Pack<Width>::Real;
template <int Width>
using TimedVector = Vector<TimedReal<Width>>;

/// conj(a) b.
template <class R>
LINKWRIGHT_INLINE Vector<R> conjugate_product(Vector<R> a, Vector<R> b) {
  return {dot(a, b), cross(a, b)};
}

/// Weighted means over the points, of V = even ± odd, the coupler's direction in both assembly modes, the input's
/// direction E and the target T.
template <int Width>
struct TimedSums {
  TimedVector<Width> input{};                      ///< of E
  TimedVector<Width> even{}, odd{};                ///< of V
  TimedVector<Width> input_even{}, input_odd{};    ///< of conj(E) V
  TimedVector<Width> input_target{};               ///< of conj(E) T
  TimedVector<Width> even_target{}, odd_target{};  ///< of conj(V) T
  TimedVector<Width> input_mirror{};               ///< of conj(E) conj(T), and so on
  TimedVector<Width> even_mirror{}, odd_mirror{};
  TimedReal<Width> least{};  ///< of what the closing of the loop takes the root of
};

template <int Width>
LINKWRIGHT_INLINE TimedSums<Width> timed_sums(const TimedBlock& block, int at) {
  using R = TimedReal<Width>;
  const R g = load<Width>(block.ground + at), h = load<Width>(block.coupler + at), b = load<Width>(block.output + at);
  const TimedVector<Width> phase{load<Width>(block.phase[0] + at), load<Width>(block.phase[1] + at)};
  const R excess = (b - h) * (b + h), scale = 0.5 / h;
  TimedSums<Width> sums;
  sums.least = R{} + 1.0;
  for (int j = 0; j < block.points; ++j) {
    const TimedVector<Width> e = product(phase, {R{} + block.turn[j][0], R{} + block.turn[j][1]});
    const TimedVector<Width> w{e.x - g, e.y};  // from the output's fixed pivot to the input's moving one
    const R square = dot(w, w), along = scale * (excess - square), under = square - along * along;
    sums.least = smaller(sums.least, under);
    const R inverse = 1.0 / square;
    const TimedVector<Width> even = along * inverse * w;
    const R across = square_root<Width>(larger(under, R{})) * inverse;
    const TimedVector<Width> odd{R{} - across * w.y, across * w.x};
    const R weight = R{} + block.weight[j];
    const TimedVector<Width> target{R{} + block.weight[j] * block.point[j][0],
                                    R{} + block.weight[j] * block.point[j][1]};
    const TimedVector<Width> mirror{target.x, R{} - target.y};
    sums.input = sums.input + weight * e;
    sums.even = sums.even + weight * even;
    sums.odd = sums.odd + weight * odd;
    sums.input_even = sums.input_even + weight * conjugate_product(e, even);
    sums.input_odd = sums.input_odd + weight * conjugate_product(e, odd);
    sums.input_target = sums.input_target + conjugate_product(e, target);
    sums.even_target = sums.even_target + conjugate_product(even, target);
    sums.odd_target = sums.odd_target + conjugate_product(odd, target);
    sums.input_mirror = sums.input_mirror + conjugate_product(e, mirror);
    sums.even_mirror = sums.even_mirror + conjugate_product(even, mirror);
    sums.odd_mirror = sums.odd_mirror + conjugate_product(odd, mirror);
  }
  return sums;
}

/// What is left of the target by c0 + c1 E + c2 V at its best; where the direction of E is prescribed c1 is a positive
/// multiple of the conjugate of the phase.
template <int Width>
LINKWRIGHT_INLINE TimedReal<Width> left_of_target(const TimedBlock& block, TimedReal<Width> target_square,
                                                  TimedReal<Width> ee, TimedReal<Width> vv, TimedVector<Width> ev,
                                                  TimedVector<Width> et, TimedVector<Width> vt,
                                                  TimedVector<Width> phase) {
  using R = TimedReal<Width>;
  constexpr double regular = 1e-12;
  const R det = ee * vv - dot(ev, ev) + regular, inverse = 1.0 / det;
  const TimedVector<Width> c1 = inverse * (vv * et - product(ev, vt));
  const TimedVector<Width> c2 = inverse * (ee * vt - conjugate_product(ev, et));
  R left = target_square - dot(et, c1) - dot(vt, c2);
  if (block.absolute) {
    const TimedVector<Width> turned = product(c1, phase);
    left = left + det / (vv + regular) * turned.y * turned.y;
    left = select<Width>(less<Width>(turned.x, R{}), R{} + TimedBlock::unreached, left);
  }
  return larger(left, R{});
}

template <int Width>
LINKWRIGHT_INLINE void timed_scan_pack(TimedBlock& block, double target_square, int at) {
  using R = TimedReal<Width>;
  const TimedSums<Width> sums = timed_sums<Width>(block, at);
  const TimedVector<Width> phase{load<Width>(block.phase[0] + at), load<Width>(block.phase[1] + at)};
  const Mask open = less<Width>(sums.least, R{});
  for (int variant = 0; variant < TimedBlock::variants; ++variant) {
    const R sign = R{} + (variant % 2 == 0 ? 1.0 : -1.0);
    const bool mirrored = variant >= 2;
    const TimedVector<Width> v = sums.even + sign * sums.odd;
    const R ee = 1.0 - dot(sums.input, sums.input), vv = 1.0 - dot(v, v);
    const TimedVector<Width> ev = sums.input_even + sign * sums.input_odd - conjugate_product(sums.input, v);
    const TimedVector<Width> et = mirrored ? sums.input_mirror : sums.input_target;
    const TimedVector<Width> vt =
        mirrored ? sums.even_mirror + sign * sums.odd_mirror : sums.even_target + sign * sums.odd_target;
    const R left = left_of_target<Width>(block, R{} + target_square, ee, vv, ev, et, vt, phase);
    store<Width>(select<Width>(open, R{} + TimedBlock::unreached, left), block.squares[variant] + at);
  }
}

template <int Width>
void timed_scan_kernel(TimedBlock& block) {
  double square = 0;
  for (int j = 0; j < block.points; ++j)
    square += block.weight[j] * (block.point[j][0] * block.point[j][0] + block.point[j][1] * block.point[j][1]);
  for (int at = 0; at < block.count; at += Width) timed_scan_pack<Width>(block, square, at);
}

}  // namespace linkwright::LINKWRIGHT_ISA
