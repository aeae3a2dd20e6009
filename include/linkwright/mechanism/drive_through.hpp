#pragma once

#include <span>
#include <vector>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

struct DriveThroughOptions {
  double step = 5e-2;  ///< longest arc length of a step on the unit torus of the three link angles, radians;
                       ///< steps are shorter where strands of the curve pass close to each other
  /// Loop closure error, relative to the perimeter, at which a corrector step ends.
  double corrector = tolerance::on_curve;
  double pose_tolerance = 1e-3;  ///< largest distance from a pose that counts as met, radians on the torus
  int max_steps = 4'000'000;     ///< for one circuit

  /// A pose with derivatives must be passed in the direction of its first one, to within `miss` radians: it is compared
  /// with the numerically differentiated drive.
  bool respect_direction = false;
};

/// What driving showed: an answer that shares nothing with find_defects.
struct DriveThroughReport {
  /// The circuit closed, or all poses lie on the arc around pose 0 on which it can be followed: where it crosses
  /// itself, at a change point (tolerance::crossing_strands), that arc ends. Otherwise the rest is meaningless: no
  /// linkage, poses beyond a crossing, max_steps.
  bool completed = false;
  Defects defects;
  /// Pose indices on the circuit, in the order in which the input meets them from pose 0, in the sense that reaches
  /// pose 1 first.
  std::vector<int> visited;
  double worst_closure = 0;     ///< largest loop closure error met, relative to the perimeter
  double worst_pose_error = 0;  ///< largest distance of the coupler's pivots from where a visited pose wants them
  /// Largest angle, radians in [0, π/2], between the velocities of the coupler's pivots (as one vector of four numbers)
  /// and those that the first derivative of a visited pose wants, or their opposite; 0 where no pose has any.
  double worst_direction_error = 0;
};

/// Drives the four-bar by its input through the poses, slowly: traces the whole circuit of configurations by
/// arc-length continuation of the loop equation with a Newton corrector, notes where each pose is met and where the
/// input's dead points lie (the loop Jacobian by coupler and output angle changes sign), and reads the defects off.
/// Steps are bounded so that the walk provably stays on its strand of the curve
/// (src/mechanism/configuration_curve.cpp). `poses` as in find_defects, but the direction in which they are passed is
/// judged only where the options say so; then the verdict is that of find_defects with respect for the direction,
/// otherwise that without. Second and higher derivatives play no part. A pose that the linkage does not reach at all
/// counts as one on another circuit; one that it passes only in other directions, or with the input at rest, is an
/// order defect.
[[nodiscard]] DriveThroughReport drive_through(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                               const DriveThroughOptions& options = {});

}  // namespace linkwright
