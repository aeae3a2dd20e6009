#pragma once

// What samples of any linkage are judged by, one sample to each lane.

#include "core/pack.hpp"
#include "robust/sampling_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::sampling {

template <int Width>
using Real = typename Pack<Width>::Real;

/// The square of the angle between unit vectors from that of their chord, within 1e-15 of it: 4 asin²(c/2) by its
/// series below some 7°, otherwise by the polynomials of FDLIBM (Sun Microsystems, 1993: e_asin.c).
template <int Width>
LINKWRIGHT_INLINE Real<Width> angle_square(Real<Width> chord_square) {
  using R = Real<Width>;
  const R q = 0.25 * chord_square;
  // asin² x = ½ Σ (2x)²ⁿ / (n² C(2n, n))
  const R series =
      q * (1.0 + q * (1.0 / 3 +
                      q * (8.0 / 45 + q * (4.0 / 35 + q * (128.0 / 1575 + q * (128.0 / 2079 + q * 1024.0 / 21021))))));
  const Mask large = less<Width>(R{} + 0.004, q);
  if (!large) return 4.0 * series;
  const R x = smaller(square_root<Width>(q), R{} + 1.0);
  const Mask above = less<Width>(R{} + 0.5, x);
  const R z = select<Width>(above, 0.5 * (1.0 - x), x * x);
  const R p = z * (1.66666666666666657415e-01 +
                   z * (-3.25565818622400915405e-01 +
                        z * (2.01212532134862925881e-01 +
                             z * (-4.00555345006794114027e-02 +
                                  z * (7.91534994289814532176e-04 + z * 3.47933107596021167570e-05)))));
  const R divisor =
      1.0 + z * (-2.40339491173441421878e+00 +
                 z * (2.02094576023350569471e+00 + z * (-6.88283971605453293030e-01 + z * 7.70381505559019352791e-02)));
  const R root = square_root<Width>(z), arc = root + root * (p / divisor);
  const R angle = 2.0 * select<Width>(above, 0x1.921fb54442d18p0 - 2.0 * arc, arc);
  return select<Width>(large, angle * angle, 4.0 * series);
}

/// Notes which samples assemble in all positions, and how many of them keep the limit with their squared error.
template <int Width>
LINKWRIGHT_INLINE void count_lanes(SampledBlock& block, int at, Mask assembled, Real<Width> error) {
  const int counts = block.samples - at;  // of these lanes
  if (counts < Width) assembled &= counts > 0 ? (1u << counts) - 1 : 0;
  unsigned char& bits = block.assembled[at / 8];
  bits = static_cast<unsigned char>((at % 8 == 0 ? 0u : bits) | assembled << at % 8);
  const Mask good = assembled & negated<Width>(less<Width>(Real<Width>{} + block.limit_square, error));
  block.assembled_count += __builtin_popcount(assembled);
  block.good_count += __builtin_popcount(good);
}

/// Of a number of each sample that is assembled. By eight, whatever the width, so that all of them round alike.
template <int Width, class Number>
LINKWRIGHT_INLINE double sum(const SampledBlock& block, const Number& number) {
  using R = Real<Width>;
  constexpr int lanes = 8, parts = lanes / Width;
  R sums[parts] = {};
  for (int at = 0; at < SampledBlock::size; at += lanes)
    for (int part = 0; part < parts; ++part) {
      const Mask assembled = Mask{block.assembled[at / lanes]} >> part * Width & all_lanes<Width>;
      sums[part] = sums[part] + where<Width>(assembled, number(at + part * Width));
    }
  double each[lanes], sum = 0;
  for (int part = 0; part < parts; ++part) store<Width>(sums[part], &each[part * Width]);
  for (const double one : each) sum += one;
  return sum;
}

/// Adds up what `lanes(at)` leaves, `square(j, at)` being the squared error in a position.
template <int Width, class Lanes, class Square>
LINKWRIGHT_INLINE void sample_block(SampledBlock& block, const Lanes& lanes, const Square& square) {
  block.assembled_count = block.good_count = 0;
  for (int at = 0; at < SampledBlock::size; at += Width) lanes(at);
  const auto worst = [&](int at) { return load<Width>(&block.worst[at]); };
  block.worst_square_sum = sum<Width>(block, worst);
  block.worst_sum = sum<Width>(block, [&](int at) { return square_root<Width>(worst(at)); });
  for (int j = 0; j < block.positions; ++j)
    block.square_sum[j] = sum<Width>(block, [&](int at) { return square(j, at); });
}

}  // namespace linkwright::LINKWRIGHT_ISA::sampling
