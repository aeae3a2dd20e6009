#pragma once

// Spherical four-bars made with errors, one sample to each lane. A position is the spherical triangle of coupler,
// output and diagonal, its vectors without trigonometry but that of the arcs.

#include "core/pack_vector.hpp"
#include "robust/sampled_block_lanes.hpp"

namespace linkwright::LINKWRIGHT_ISA::spherical_sampling {

using sampling::Real;

/// s a + t b
template <class R>
LINKWRIGHT_INLINE Vector3<R> combined(R s, Vector3<R> a, R t, Vector3<R> b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
}
template <class R>
LINKWRIGHT_INLINE Vector3<R> in_all_lanes(const double v[3]) {
  return {R{} + v[0], R{} + v[1], R{} + v[2]};
}
template <class R>
LINKWRIGHT_INLINE R square_off(Vector3<R> v, const double nominal[3]) {
  const Vector3<R> off = {v.x - nominal[0], v.y - nominal[1], v.z - nominal[2]};
  return dot(off, off);
}

/// One sample of the linkage to each lane.
template <int Width>
struct Linkage {
  SineCosine<Width> input, coupler, output, driver;
  Vector3<Real<Width>> fixed_axis, output_fixed, along_ground, across_ground;
  Real<Width> of_coupler, of_output;  ///< inverse sines
  Mask made;                          ///< its arcs lie between 0 and a half turn
};

template <int Width>
LINKWRIGHT_INLINE Linkage<Width> linkage_at(const SphericalSamplingBlock& block, int at) {
  using R = Real<Width>;
  const auto arc = [&](int i) { return sine_cosine<Width>(block.arc[i] + load<Width>(&block.deviation[i][at])); };
  Linkage<Width> l;
  l.input = arc(0);
  l.coupler = arc(1);
  l.output = arc(2);
  const SineCosine<Width> ground = arc(3);
  l.driver = {R{}, R{} + 1.0};
  if (block.driver_errs) l.driver = sine_cosine<Width>(load<Width>(&block.deviation[4][at]));
  l.fixed_axis = in_all_lanes<R>(block.fixed_axis);
  const Vector3<R> along = in_all_lanes<R>(block.ground);
  l.output_fixed = combined<R>(ground.cosine, l.fixed_axis, ground.sine, along);
  l.along_ground = combined<R>(ground.cosine, along, -ground.sine, l.fixed_axis);
  l.across_ground = cross(l.fixed_axis, along);
  l.of_coupler = 1.0 / l.coupler.sine;
  l.of_output = 1.0 / l.output.sine;
  const R none = R{};
  l.made = less<Width>(none, l.input.sine) & less<Width>(none, l.coupler.sine) & less<Width>(none, l.output.sine) &
           less<Width>(none, ground.sine);
  return l;
}

template <class R>
struct Position {
  Vector3<R> input_moving, output_moving;
  Mask assembled;
};

template <int Width>
LINKWRIGHT_INLINE Position<Real<Width>> position_of(const Linkage<Width>& l, const SphericalSamplingBlock& block,
                                                    int j) {
  using R = Real<Width>;
  Vector3<R> input = in_all_lanes<R>(block.input_direction[j]);
  if (block.driver_errs) input = combined<R>(l.driver.cosine, input, l.driver.sine, cross(l.fixed_axis, input));
  const Vector3<R> w1 = combined<R>(l.input.cosine, l.fixed_axis, l.input.sine, input);
  const Vector3<R> across = cross(l.output_fixed, w1);
  const R square = dot(across, across), inverse = 1.0 / square, diagonal = dot(w1, l.output_fixed);
  // W₂ in the oblique frame of W₁, G₂ and G₂ × W₁, det [W₁ W₂ G₂] being its part along the last.
  const R along_w1 = (l.coupler.cosine - diagonal * l.output.cosine) * inverse;
  const R along_g2 = (l.output.cosine - diagonal * l.coupler.cosine) * inverse;
  const R rest = (1.0 - along_w1 * l.coupler.cosine - along_g2 * l.output.cosine) * inverse;
  const R part = block.assembly[j] * square_root<Width>(larger(rest, R{}));
  const Vector3<R> flat = combined<R>(along_w1, w1, along_g2, l.output_fixed);
  return {w1, combined<R>(R{} + 1.0, flat, part, across),
          less<Width>(R{}, square) & negated<Width>(negative<Width>(rest))};
}

/// Squared angle by which the coupler is turned off its nominal position: three axes fast to it are off by 8 sin²(θ/2).
template <int Width>
LINKWRIGHT_INLINE Real<Width> coupler_error(const Linkage<Width>& l, const Position<Real<Width>>& there,
                                            const double nominal[3][3]) {
  using R = Real<Width>;
  const Vector3<R> toward =
      combined<R>(l.of_coupler, there.output_moving, -l.coupler.cosine * l.of_coupler, there.input_moving);
  const R off = square_off<R>(there.input_moving, nominal[0]) + square_off<R>(toward, nominal[1]) +
                square_off<R>(cross(there.input_moving, toward), nominal[2]);
  return sampling::angle_square<Width>(0.5 * off);
}

template <int Width>
LINKWRIGHT_INLINE Real<Width> output_error(const Linkage<Width>& l, const Position<Real<Width>>& there,
                                           const double nominal[2]) {
  using R = Real<Width>;
  const R x = dot(there.output_moving, l.along_ground) * l.of_output - nominal[0];
  const R y = dot(there.output_moving, l.across_ground) * l.of_output - nominal[1];
  return sampling::angle_square<Width>(x * x + y * y);
}

template <int Width>
LINKWRIGHT_INLINE void sample_lanes(SphericalSamplingBlock& block, int at) {
  using R = Real<Width>;
  const Linkage<Width> linkage = linkage_at<Width>(block, at);
  Mask assembled = linkage.made;
  R worst = R{};
  for (int j = 0; j < block.positions; ++j) {
    const Position<R> there = position_of<Width>(linkage, block, j);
    assembled &= there.assembled;
    const R error = block.of_output ? output_error<Width>(linkage, there, block.output[j])
                                    : coupler_error<Width>(linkage, there, block.coupler[j]);
    worst = larger(worst, error);
    store<Width>(error, &block.error[j][at]);
  }
  store<Width>(worst, &block.worst[at]);
  sampling::count_lanes<Width>(block, at, assembled, worst);
}

template <int Width>
void spherical_sampling_kernel(SphericalSamplingBlock& block) {
  sampling::sample_block<Width>(
      block, [&](int at) { sample_lanes<Width>(block, at); },
      [&](int j, int at) { return load<Width>(&block.error[j][at]); });
}

}  // namespace linkwright::LINKWRIGHT_ISA::spherical_sampling
