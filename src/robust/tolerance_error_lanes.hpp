#pragma once

// The tolerance error of four-bars in closed form, one to each lane: the sums over the parameters are written out, so
// that a position costs a division and nothing costs a root but the end.

#include "core/pack_vector.hpp"
#include "robust/tolerance_error_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::tolerance_error {

template <int Width>
using Real = typename Pack<Width>::Real;

template <int Width>
LINKWRIGHT_INLINE Vector<Real<Width>> load_vector(const double from[2][ToleranceErrorBlock::size], int at) {
  return {load<Width>(&from[0][at]), load<Width>(&from[1][at])};
}

/// The squares of the links, which do not change from position to position.
template <class R>
struct Squares {
  R input, over_input, coupler, over_coupler, output;
};

/// Variance of x, y and turning_length · θ together. Of a parameter that opens the loop by v, the coupler turns by
/// −(v · output) / (coupler × output), and the point goes along with v, where it does, and with the turn.
template <int Width>
LINKWRIGHT_INLINE Real<Width> variance(const ToleranceErrorBlock::Variances& of, double turning_square,
                                       Vector<Real<Width>> input, Vector<Real<Width>> coupler,
                                       Vector<Real<Width>> output, Vector<Real<Width>> arm,
                                       const Squares<Real<Width>>& squares) {
  using R = Real<Width>;
  const R m = 1.0 / cross(coupler, output), m_square = m * m;
  const R turned = (dot(arm, arm) + turning_square) * m_square;  // by a turn's square
  const R by_input = dot(input, output), by_coupler = dot(coupler, output), by_driver = cross(input, output);
  const R of_links =
      of.coupler * squares.over_coupler * by_coupler * by_coupler + (of.output + 2 * of.ground_pivots) * squares.output;
  const R input_alone = 1.0 + squares.over_input * by_input * (2.0 * cross(input, arm) * m + turned * by_input);
  const R center_alone = 2.0 + 2.0 * cross(output, arm) * m;
  const R driver_alone = squares.input + by_driver * (turned * by_driver - 2.0 * dot(input, arm) * m);
  return of_links * turned + of.input * input_alone + of.ground_pivots * center_alone + of.driver * driver_alone;
}

/// Variance of the output's angle: a parameter that opens the loop by v turns it by −(v · coupler) / (coupler ×
/// output).
template <int Width>
LINKWRIGHT_INLINE Real<Width> angle_variance(const ToleranceErrorBlock::Variances& of, Vector<Real<Width>> input,
                                             Vector<Real<Width>> coupler, Vector<Real<Width>> output,
                                             const Squares<Real<Width>>& squares) {
  using R = Real<Width>;
  const R m = 1.0 / cross(coupler, output);
  const R by_input = dot(input, coupler), by_output = dot(output, coupler), by_driver = cross(input, coupler);
  return m * m *
         (of.input * squares.over_input * by_input * by_input + (of.coupler + 2 * of.ground_pivots) * squares.coupler +
          of.output * by_output * by_output / squares.output + of.driver * by_driver * by_driver);
}

template <int Width>
LINKWRIGHT_INLINE void error_lanes(ToleranceErrorBlock& block, int at) {
  using R = Real<Width>;
  const double turning_square = block.turning_length * block.turning_length;
  const Vector<R> input_fixed = load_vector<Width>(block.input_fixed, at);
  const Vector<R> output_fixed = load_vector<Width>(block.output_fixed, at);
  Squares<R> squares;
  R sum = R{};
  for (int j = 0; j < block.positions; ++j) {
    const Vector<R> input_moving = load_vector<Width>(block.input_moving[j], at);
    const Vector<R> output_moving = load_vector<Width>(block.output_moving[j], at);
    const Vector<R> input = input_moving - input_fixed, output = output_moving - output_fixed;
    const Vector<R> coupler = output_moving - input_moving;
    if (j == 0)
      squares = {dot(input, input), 1.0 / dot(input, input), dot(coupler, coupler), 1.0 / dot(coupler, coupler),
                 dot(output, output)};
    if (block.kind == ToleranceErrorBlock::angle) {
      sum = sum + angle_variance<Width>(block.variances, input, coupler, output, squares);
      continue;
    }
    const Vector<R> arm = {block.point[j][0] - input_moving.x, block.point[j][1] - input_moving.y};
    sum = sum + variance<Width>(block.variances, turning_square, input, coupler, output, arm, squares);
  }
  const double of_point = block.kind == ToleranceErrorBlock::pose ? 2 * block.variances.point : 0;
  const R mean = sum * (1.0 / block.positions) + of_point;
  const Mask finite = less<Width>(mean, R{} + __builtin_huge_val());
  const R error = square_root<Width>(where<Width>(finite, mean));
  store<Width>(R(select<Width>(finite, error, R{} + __builtin_huge_val())), &block.error[at]);
}

template <int Width>
void tolerance_error_kernel(ToleranceErrorBlock& block) {
  for (int at = 0; at < ToleranceErrorBlock::size; at += Width) error_lanes<Width>(block, at);
}

}  // namespace linkwright::LINKWRIGHT_ISA::tolerance_error
