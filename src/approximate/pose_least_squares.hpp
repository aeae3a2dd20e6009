#pragma once

#include <span>
#include <vector>

#include "approximate/body_linkage.hpp"
#include "approximate/damped_least_squares.hpp"
#include "approximate/fit_limits.hpp"

namespace linkwright {

inline constexpr std::size_t body_dimensions = 10;

/// Poses that a linkage is fitted to, and what it is held to; one frame and unit, best one in which both are about 1.
struct PoseFitTask {
  std::span<const BodyPose> poses;
  std::span<const double> weights;  ///< one to each pose, ≥ 0
  double turning_length = 1;        ///< a turn by 1 radian counts as this displacement
  FitLimits limits;
  std::span<const std::size_t> exact = {};  ///< poses whose weights stand for "exactly", rising
};

/// A linkage on its way to a least sum of squares.
struct BodyStart {
  BodyLinkage linkage;
  std::vector<BodyPose> states;  ///< one to each pose, as the linkage lets it
  /// Sign of cross(u, B − B0) to be kept at all poses, so that no dead point of the input is between; 0: free.
  int branch = 0;
  /// A bit to each of a0.x, a0.y, b0.x, b0.y, a, b, za.x, za.y, zb.x, zb.y that is held.
  unsigned held = 0;
  double damping = 1e-3;
  double squares = 0;    ///< weighted sum of squared displacements from the poses to the states
  double penalties = 0;  ///< sum of squared hinges
  bool converged = false;

  [[nodiscard]] double cost() const { return squares + penalties; }
};

/// The sums of a linkage at its states.
void evaluate(const PoseFitTask& task, BodyStart& start);

/// Levenberg–Marquardt over the ten numbers of the linkage, the states eliminated: each slides along its curve to where
/// it is nearest to its pose, so that what counts are the two components of the displacement across the curve.
void improve(const PoseFitTask& task, BodyStart& start, int iterations);

/// The states slide to where they are nearest to the poses; the linkage stays.
void slide_to_nearest(const PoseFitTask& task, BodyStart& start);

/// The pose that a linkage leaves, near a state of its, that is nearest to one asked for.
[[nodiscard]] BodyPose nearest_state(const BodyLinkage& linkage, BodyPose state, const BodyPose& pose,
                                     double turning_length);

using BodyRow = LeastSquaresRow<body_dimensions>;

/// The components of the displacement from a pose to the state across the curve of states, and how they change.
[[nodiscard]] std::array<BodyRow, 2> displacement_rows(const BodyLinkage& linkage, const BodyPose& at,
                                                       const BodyPose& pose, double turning_length);

/// cross(u, B − B0)/b at a state, the sine of the transmission angle with a sign, and how it changes while the state
/// stays nearest.
[[nodiscard]] BodyRow transmission_sine_row(const BodyLinkage& linkage, const BodyPose& at, const BodyPose& pose,
                                            double turning_length);

/// The start's linkage from its other grounded link.
void turn_round(BodyStart& start);

}  // namespace linkwright
