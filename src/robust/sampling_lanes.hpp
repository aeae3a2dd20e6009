#pragma once

// Planar four-bars made with errors, one sample to each lane. A position is the triangle of coupler, output and
// diagonal, without trigonometry.

#include "core/pack.hpp"
#include "robust/sampling_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::sampling {

template <int Width>
using Real = typename Pack<Width>::Real;

template <class R>
struct Vector {
  R x, y;
};
template <class R>
LINKWRIGHT_INLINE R square(Vector<R> v) {
  return v.x * v.x + v.y * v.y;
}

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

/// One sample of the linkage to each lane.
template <class R>
struct Linkage {
  R input, coupler_square, output_square, of_coupler, of_output;  ///< the last two: inverse lengths
  Vector<R> input_center, output_center, arm, driver;             ///< driver: by which the input's direction is turned
  Mask made;                                                      ///< its links have lengths
};

template <int Width>
LINKWRIGHT_INLINE Linkage<Real<Width>> linkage_at(const SamplingBlock& block, int at) {
  using R = Real<Width>;
  const auto with = [&](double nominal, int parameter) {
    return nominal + load<Width>(&block.deviation[parameter][at]);
  };
  const R input = with(block.input, 0), coupler = with(block.coupler, 1), output = with(block.output, 2);
  Vector<R> driver = {R{} + 1.0, R{}};
  if (block.driver_errs) {
    const auto turn = sine_cosine<Width>(load<Width>(&block.deviation[9][at]));
    driver = {turn.cosine, turn.sine};
  }
  return {input,
          coupler * coupler,
          output * output,
          1.0 / coupler,
          1.0 / output,
          {with(block.input_center[0], 3), with(block.input_center[1], 4)},
          {with(block.output_center[0], 5), with(block.output_center[1], 6)},
          {with(block.arm[0], 7), with(block.arm[1], 8)},
          driver,
          less<Width>(R{}, input) & less<Width>(R{}, coupler) & less<Width>(R{}, output)};
}

template <class R>
struct Position {
  Vector<R> point, coupler, output;  ///< directions of the links
  Mask assembled;
};

template <int Width>
LINKWRIGHT_INLINE Position<Real<Width>> position_of(const Linkage<Real<Width>>& l, const SamplingBlock& block, int j) {
  using R = Real<Width>;
  Vector<R> input = {R{} + block.input_direction[j][0], R{} + block.input_direction[j][1]};
  if (block.driver_errs)
    input = {input.x * l.driver.x - input.y * l.driver.y, input.x * l.driver.y + input.y * l.driver.x};
  const Vector<R> circle = {l.input_center.x + l.input * input.x, l.input_center.y + l.input * input.y};
  const Vector<R> diagonal = {l.output_center.x - circle.x, l.output_center.y - circle.y};
  const R inverse = 1.0 / square(diagonal);
  // The coupler as shares of the diagonal, along it and to its left.
  const R along = 0.5 + 0.5 * (l.coupler_square - l.output_square) * inverse;
  const R across_square = l.coupler_square * inverse - along * along;
  const Mask assembled = negated<Width>(negative<Width>(across_square));
  const R across = block.assembly[j] * square_root<Width>(larger(across_square, R{}));
  const Vector<R> coupler = {diagonal.x * along - diagonal.y * across, diagonal.y * along + diagonal.x * across};
  const Vector<R> direction = {coupler.x * l.of_coupler, coupler.y * l.of_coupler};
  return {{circle.x + l.arm.x * direction.x - l.arm.y * direction.y,
           circle.y + l.arm.x * direction.y + l.arm.y * direction.x},
          direction,
          {(coupler.x - diagonal.x) * l.of_output, (coupler.y - diagonal.y) * l.of_output},
          assembled};
}

template <int Width>
LINKWRIGHT_INLINE Real<Width> turned_square(Vector<Real<Width>> direction, const double nominal[2]) {
  return angle_square<Width>(square(Vector<Real<Width>>{direction.x - nominal[0], direction.y - nominal[1]}));
}

/// Takes the straight line that fits best by least squares away from what the samples' points deviate.
template <int Width>
LINKWRIGHT_INLINE void realign(SamplingBlock& block, int at) {
  using R = Real<Width>;
  R mean = R{}, slope = R{};
  for (int j = 0; j < block.positions; ++j) {
    const R error = load<Width>(&block.error[j][at]);
    mean = mean + error;
    slope = slope + block.place[j] * error;
  }
  mean = mean * (1.0 / block.positions);
  for (int j = 0; j < block.positions; ++j)
    store<Width>(R(load<Width>(&block.error[j][at]) - mean - slope * block.place[j]), &block.error[j][at]);
}

/// Squared, from the line where it was drawn or in the middle of what a realigned one leaves.
template <int Width>
LINKWRIGHT_INLINE Real<Width> largest_distance(SamplingBlock& block, int at) {
  using R = Real<Width>;
  if (block.realigned) realign<Width>(block, at);
  R low = load<Width>(&block.error[0][at]), high = low;
  for (int j = 1; j < block.positions; ++j) {
    const R distance = load<Width>(&block.error[j][at]);
    low = smaller(low, distance);
    high = larger(high, distance);
  }
  const R largest = block.realigned ? R(0.5 * (high - low)) : larger(R(-low), high);
  return largest * largest;
}

template <int Width>
LINKWRIGHT_INLINE void sample_lanes(SamplingBlock& block, int at) {
  using R = Real<Width>;
  const Linkage<R> linkage = linkage_at<Width>(block, at);
  Mask assembled = linkage.made;
  R worst = R{}, limit = R{};
  for (int j = 0; j < block.positions; ++j) {
    const Position<R> there = position_of<Width>(linkage, block, j);
    assembled &= there.assembled;
    R error;
    if (block.kind == SamplingBlock::line) {
      error = block.line_left[0] * (there.point.x - block.line_point[0]) +
              block.line_left[1] * (there.point.y - block.line_point[1]);
    } else if (block.kind == SamplingBlock::angle) {
      error = turned_square<Width>(there.output, block.direction[j]);
      worst = larger(worst, error);
    } else {
      const R of_point = square(Vector<R>{there.point.x - block.point[j][0], there.point.y - block.point[j][1]});
      const R of_angle = turned_square<Width>(there.coupler, block.direction[j]);
      error = block.error_of_point * of_point + block.error_of_angle * of_angle;
      worst = larger(worst, error);
      limit = larger(limit, R(block.limit_of_point * of_point + block.limit_of_angle * of_angle));
    }
    store<Width>(error, &block.error[j][at]);
  }
  if (block.kind == SamplingBlock::line) worst = largest_distance<Width>(block, at);
  store<Width>(worst, &block.worst[at]);
  const int counts = block.samples - at;  // of these lanes
  if (counts < Width) assembled &= counts > 0 ? (1u << counts) - 1 : 0;
  unsigned char& bits = block.assembled[at / 8];
  bits = static_cast<unsigned char>((at % 8 == 0 ? 0u : bits) | assembled << at % 8);
  if (block.kind != SamplingBlock::pose) limit = worst;
  const Mask good = assembled & negated<Width>(less<Width>(R{} + block.limit_square, limit));
  block.assembled_count += __builtin_popcount(assembled);
  block.good_count += __builtin_popcount(good);
}

/// Of a number of each sample that is assembled. By eight, whatever the width, so that all of them round alike.
template <int Width, class Number>
LINKWRIGHT_INLINE double sum(const SamplingBlock& block, const Number& number) {
  using R = Real<Width>;
  constexpr int lanes = 8, parts = lanes / Width;
  R sums[parts] = {};
  for (int at = 0; at < SamplingBlock::size; at += lanes)
    for (int part = 0; part < parts; ++part) {
      const Mask assembled = Mask{block.assembled[at / lanes]} >> part * Width & all_lanes<Width>;
      sums[part] = sums[part] + where<Width>(assembled, number(at + part * Width));
    }
  double each[lanes], sum = 0;
  for (int part = 0; part < parts; ++part) store<Width>(sums[part], &each[part * Width]);
  for (const double one : each) sum += one;
  return sum;
}

template <int Width>
void sampling_kernel(SamplingBlock& block) {
  block.assembled_count = block.good_count = 0;
  for (int at = 0; at < SamplingBlock::size; at += Width) sample_lanes<Width>(block, at);
  const auto worst = [&](int at) { return load<Width>(&block.worst[at]); };
  block.worst_square_sum = sum<Width>(block, worst);
  block.worst_sum = sum<Width>(block, [&](int at) { return square_root<Width>(worst(at)); });
  for (int j = 0; j < block.positions; ++j)
    block.square_sum[j] = sum<Width>(block, [&](int at) {
      const Real<Width> error = load<Width>(&block.error[j][at]), off = error - block.nominal[j];
      return block.kind == SamplingBlock::line ? Real<Width>(off * off) : error;
    });
}

}  // namespace linkwright::LINKWRIGHT_ISA::sampling
