#pragma once

#include "approximate/curve_least_squares.hpp"

namespace linkwright {

/// What a state does while the linkage changes by dx: it closes along the gradient of the loop, and slides along the
/// curve to where its point is nearest to a target.
struct LoopSlide {
  /// |velocity|² of the point along the curve that counts as none, in the unit of the task: at a cusp the path all but
  /// stands still, and a slide is of no use.
  static constexpr double rest = 1e-9;

  LoopGradient loop;
  double square, length;  ///< of the gradient
  Point velocity;         ///< of the point by the arc of the state
  Point off;              ///< from the target to the point
  Point closure;          ///< of the point, by the closure error, along the gradient: over its square
  double stiffness;       ///< 1/(|velocity|² + rest)
  /// The change of f by dx; that of the point's place once the loop is closed again; and that of the slide.
  std::array<double, fit_dimensions> closure_row;
  std::array<Point, fit_dimensions> point_rows;
  std::array<double, fit_dimensions> slide_row;
  double slide = 0;  ///< arc to where the point is nearest, to first order

  LoopSlide(const CouplerLinkage& linkage, const LoopState& at, Point target) : loop(linkage, at) {
    const Point by_e = linkage.a * quarter_turn(at.e), by_u = quarter_turn(product(linkage.p, at.u));
    square = loop.square() + 1e-300;
    length = std::sqrt(square);
    velocity = (loop.f_e * by_u - loop.f_u * by_e) / length;
    off = traced_point(linkage, at) - target;
    closure = (loop.f_e * by_e + loop.f_u * by_u) / square;
    stiffness = 1 / (std::norm(velocity) + rest);
    const Point g = loop.g, iu = quarter_turn(at.u);
    closure_row = {g.real(), g.imag(), -g.real(), -g.imag(), dot(g, at.e), dot(g, at.u), -linkage.b, 0, 0};
    point_rows = {Point{1, 0}, Point{0, 1}, Point{}, Point{}, at.e, Point{}, Point{}, at.u, iu};
    for (std::size_t i = 0; i < fit_dimensions; ++i) {
      point_rows[i] -= closure_row[i] * closure;
      slide_row[i] = -stiffness * dot(velocity, point_rows[i]);
    }
    slide = -stiffness * dot(velocity, off);
  }

  /// Of a function of the state, by its derivatives: how it changes by a closure error of 1, and by the arc.
  [[nodiscard]] double across(double by_e, double by_u) const { return (by_e * loop.f_e + by_u * loop.f_u) / square; }
  [[nodiscard]] double along(double by_e, double by_u) const { return (by_u * loop.f_e - by_e * loop.f_u) / length; }
};

}  // namespace linkwright
