#pragma once

// Planar four-bars made with errors, one sample to each lane. A position is the triangle of coupler, output and
// diagonal, without trigonometry.

#include "core/pack_vector.hpp"
#include "robust/sampled_block_lanes.hpp"

namespace linkwright::LINKWRIGHT_ISA::sampling {

/// One sample of the linkage to each lane.
template <class R>
struct Linkage {
  R input, coupler_square, output_square, of_coupler, of_output;  ///< the last two: inverse lengths
  Vector<R> input_fixed, output_fixed, arm, driver;               ///< driver: by which the input's direction is turned
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
          {with(block.input_fixed[0], 3), with(block.input_fixed[1], 4)},
          {with(block.output_fixed[0], 5), with(block.output_fixed[1], 6)},
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
  const Vector<R> circle = {l.input_fixed.x + l.input * input.x, l.input_fixed.y + l.input * input.y};
  const Vector<R> diagonal = {l.output_fixed.x - circle.x, l.output_fixed.y - circle.y};
  const R inverse = 1.0 / dot(diagonal, diagonal);
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
  const Vector<Real<Width>> chord = {direction.x - nominal[0], direction.y - nominal[1]};
  return angle_square<Width>(dot(chord, chord));
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
      const Vector<R> off = {there.point.x - block.point[j][0], there.point.y - block.point[j][1]};
      const R of_point = dot(off, off);
      const R of_angle = turned_square<Width>(there.coupler, block.direction[j]);
      error = block.error_of_point * of_point + block.error_of_angle * of_angle;
      worst = larger(worst, error);
      limit = larger(limit, R(block.limit_of_point * of_point + block.limit_of_angle * of_angle));
    }
    store<Width>(error, &block.error[j][at]);
  }
  if (block.kind == SamplingBlock::line) worst = largest_distance<Width>(block, at);
  store<Width>(worst, &block.worst[at]);
  count_lanes<Width>(block, at, assembled, block.kind == SamplingBlock::pose ? limit : worst);
}

template <int Width>
void sampling_kernel(SamplingBlock& block) {
  sample_block<Width>(
      block, [&](int at) { sample_lanes<Width>(block, at); },
      [&](int j, int at) {
        const Real<Width> error = load<Width>(&block.error[j][at]), off = error - block.nominal[j];
        return block.kind == SamplingBlock::line ? Real<Width>(off * off) : error;
      });
}

}  // namespace linkwright::LINKWRIGHT_ISA::sampling
