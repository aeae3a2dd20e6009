#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// Complex product; that of the standard library asks for NaN each time, which takes longer than the product.
[[nodiscard]] inline Point product(Point a, Point b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
/// i·a: a quarter of a turn.
[[nodiscard]] inline Point quarter_turn(Point a) { return {-a.imag(), a.real()}; }

/// A four-bar and the point of its coupler, by the nine numbers that make a coupler curve: fixed pivots a0 and b0,
/// lengths of input, coupler and output, and the point from the input's moving pivot on, x axis along the coupler.
struct CouplerLinkage {
  Point a0{}, b0{};
  double a = 0, h = 0, b = 0;
  Point p{};

  [[nodiscard]] LinkLengths lengths() const { return {std::sqrt(std::norm(b0 - a0)), a, h, b}; }
};

/// Configuration by the unit vectors along input and coupler: no angle, so no sine and no wrap.
struct LoopState {
  Point e{1, 0}, u{1, 0};
};

/// The loop at a state: closure f = (|g|² − b²)/2 of g = B − B0, and its derivatives by the turns of e and u. The curve
/// of states runs along (−f_u, f_e), through dead points as well.
struct LoopGradient {
  Point g{};
  double f = 0, f_e = 0, f_u = 0;

  LoopGradient(const CouplerLinkage& linkage, const LoopState& at)
      : g(linkage.a0 - linkage.b0 + linkage.a * at.e + linkage.h * at.u),
        f((std::norm(g) - linkage.b * linkage.b) / 2),
        f_e(linkage.a * cross(at.e, g)),
        f_u(linkage.h * cross(at.u, g)) {}

  [[nodiscard]] double square() const { return f_e * f_e + f_u * f_u; }
};

[[nodiscard]] inline Point traced_point(const CouplerLinkage& linkage, const LoopState& at) {
  return linkage.a0 + linkage.a * at.e + product(linkage.p, at.u);
}

/// Turned by small angles of e and u: by their arc tangents, and of unit length to rounding.
[[nodiscard]] inline LoopState turned(const LoopState& state, double by_e, double by_u) {
  const auto turn = [](Point v, double by) {
    constexpr double small = 1e-4;  // of the square: there the series of 1/sqrt(1 + square) is exact to 3e-13
    const double square = by * by;
    const double scale = square < small ? 1 - square * (0.5 - 0.375 * square) : 1 / std::sqrt(1 + square);
    const Point there = scale * (v + by * quarter_turn(v));
    return (1.5 - 0.5 * std::norm(there)) * there;  // a step of Newton's towards unit length
  };
  return {turn(state.e, by_e), turn(state.u, by_u)};
}

/// Newton's method onto the curve of states, along the gradient, as far as rounding lets it; false where it does not
/// get there.
[[nodiscard]] inline bool close_loop(const CouplerLinkage& linkage, LoopState& state) {
  constexpr double closed = 1e-15, closed_enough = 1e-12;  // f over the square of the largest length
  constexpr double longest_step = 0.5;                     // radians
  constexpr int most_steps = 12;
  const double scale = std::max({std::norm(linkage.a0 - linkage.b0), linkage.a * linkage.a, linkage.b * linkage.b});
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_steps; ++step) {
    const LoopGradient loop(linkage, state);
    const double error = std::abs(loop.f), square = loop.square();
    if (error <= closed * scale || (error <= closed_enough * scale && error > 0.5 * before)) return true;
    if (!(square > 0)) return false;
    before = error;
    double by = -loop.f / square;
    const double square_length = by * by * square;
    if (square_length > longest_step * longest_step) by *= longest_step / std::sqrt(square_length);
    state = turned(state, by * loop.f_e, by * loop.f_u);
  }
  return std::abs(LoopGradient(linkage, state).f) <= closed_enough * scale;
}

[[nodiscard]] inline TracingFourBar placed(const CouplerLinkage& linkage, const LoopState& at) {
  const Point moving = linkage.a0 + linkage.a * at.e;
  return {{linkage.a0, moving, linkage.b0, moving + linkage.h * at.u}, traced_point(linkage, at)};
}

/// All links have lengths, and the point is finite: what the following two ask for.
[[nodiscard]] inline bool can_move(const TracingFourBar& linkage) {
  const LinkLengths lengths = linkage.bars.lengths();
  return lengths.shortest() > 0 && std::isfinite(lengths.perimeter()) && is_finite(linkage.point);
}
[[nodiscard]] inline LoopState loop_state(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  return {(bars.input_moving - bars.input_fixed) / lengths.input,
          (bars.output_moving - bars.input_moving) / lengths.coupler};
}
[[nodiscard]] inline CouplerLinkage coupler_linkage(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  const LinkLengths lengths = bars.lengths();
  return {bars.input_fixed, bars.output_fixed,
          lengths.input,    lengths.coupler,
          lengths.output,   product(linkage.point - bars.input_moving, std::conj(loop_state(linkage).u))};
}

/// The same bars, the other fixed pivot first.
[[nodiscard]] inline CouplerLinkage swapped(const CouplerLinkage& l) { return {l.b0, l.a0, l.b, l.h, l.a, l.h - l.p}; }
[[nodiscard]] inline LoopState swapped(const CouplerLinkage& linkage, const LoopState& at) {
  return {LoopGradient(linkage, at).g / linkage.b, -at.u};
}

/// The third ground pivot of the curve (Roberts' theorem, 1875). The coupler has a length.
[[nodiscard]] inline Point third_pivot(const CouplerLinkage& l) { return l.a0 + product(l.p / l.h, l.b0 - l.a0); }

/// The cognate on the same first pivot, whose input turns as this coupler does. Neither h nor p is 0.
[[nodiscard]] inline CouplerLinkage cognate(const CouplerLinkage& l) {
  const double arm = std::abs(l.p), ratio = arm / l.h;
  return {l.a0, third_pivot(l), arm, ratio * l.a, ratio * l.b, l.a / arm * std::conj(l.p)};
}
[[nodiscard]] inline LoopState cognate(const CouplerLinkage& linkage, const LoopState& at) {
  const Point turn = linkage.p / std::abs(linkage.p);
  return {product(at.u, turn), product(at.e, turn)};
}

}  // namespace linkwright
