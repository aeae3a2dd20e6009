#pragma once

#include <optional>

#include "linkwright/algebra/point.hpp"
#include "linkwright/algebra/power_series.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// Powers of the parameter that are kept of a motion. A contact of six points takes seven; with twelve a series is
/// exact to twelve digits over a tenth of its radius of convergence, and a path takes few of them.
inline constexpr std::size_t motion_order = 12;

/// The motion of a body of the plane from where it is now, by a parameter t: the body turns by `turn` (radians) while
/// its point that lies at path.c[0] now travels along `path` (fixed frame, user's unit).
struct MotionSeries {
  ComplexSeries<motion_order> path;
  RealSeries<motion_order> turn;     ///< turn.c[0] = 0
  std::size_t order = motion_order;  ///< the highest power that is known; higher coefficients are no part of the motion

  /// Where the body's point that lies at `point` now travels.
  [[nodiscard]] ComplexSeries<motion_order> path_of(Point point) const;

  /// The same motion by its own turn; nothing where the body does not turn now (turn.c[1] = 0).
  [[nodiscard]] std::optional<MotionSeries> by_turn() const;
};

/// The turns of a four-bar's links from where it lies, radians.
struct LoopSeries {
  RealSeries<motion_order> input, coupler, output;
};

/// By the arc of the curve on the torus of the three angles, so that no link's dead point is singular; the sense is
/// that in which the input (at its dead point the coupler, then the output) turns counter-clockwise. Coefficient by
/// coefficient from the closure a e^{iφ} + h e^{iθ} − b e^{iψ} = constant: always the same two equations and, third,
/// no component along the curve (docs/theory/infinitesimal.md). Nothing where all links lie in one line: there the
/// four-bar can go several ways.
[[nodiscard]] std::optional<LoopSeries> loop_series(const FourBar& four_bar);

/// The motion of the coupler, by the parameter of loop_series().
[[nodiscard]] MotionSeries coupler_motion(const FourBar& four_bar, const LoopSeries& loop);

/// The motion of a body by a prescribed pose and its derivatives (at most motion_order of them).
[[nodiscard]] MotionSeries prescribed_motion(const PrescribedPose& pose);

}  // namespace linkwright
