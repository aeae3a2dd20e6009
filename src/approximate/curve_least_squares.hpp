#pragma once

#include <array>
#include <span>
#include <vector>

#include "approximate/damped_least_squares.hpp"
#include "approximate/fit_limits.hpp"

namespace linkwright {

/// Points that a curve is fitted to, and what the linkage is held to; one frame and unit, best one in which the points
/// have a root mean square radius of 1.
struct FitTask {
  std::span<const Point> points;
  std::span<const double> weights;  ///< one to each point, ≥ 0
  FitLimits limits;
};

/// A linkage on its way to a least sum of squares.
struct CurveStart {
  CouplerLinkage linkage;
  std::vector<LoopState> states;  ///< one to each point, closed
  /// Sign of cross(u, B − B0) to be kept at all points, so that no dead point of the input is between; 0: free.
  int branch = 0;
  /// A bit to each of a0.x, a0.y, b0.x, b0.y, a, h, b, p.x, p.y that is held.
  unsigned held = 0;
  double damping = 1e-3;
  double squares = 0;    ///< weighted sum of squared distances of the states' points
  double penalties = 0;  ///< sum of squared hinges
  bool converged = false;

  [[nodiscard]] double cost() const { return squares + penalties; }
};

inline constexpr std::size_t fit_dimensions = 9;
using FitRow = LeastSquaresRow<fit_dimensions>;

/// The sums of a linkage at its states.
void evaluate(const FitTask& task, CurveStart& start);

/// Levenberg–Marquardt over the nine numbers of the linkage, the states eliminated: a state slides along its curve to
/// where the distance is least, so that what counts is the distance across. Ends after `iterations`, or `converged`.
void improve(const FitTask& task, CurveStart& start, int iterations);

/// The states slide to where their points are nearest; the linkage stays.
void slide_to_nearest(const FitTask& task, CurveStart& start);

/// The rows of a point: the distance across the curve, and – where the path all but stands still, so that a slide is of
/// no use – what is left along it.
[[nodiscard]] std::array<FitRow, 2> distance_rows(const CouplerLinkage& linkage, const LoopState& at, Point target);

}  // namespace linkwright
