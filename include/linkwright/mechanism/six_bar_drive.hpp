#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/tolerance.hpp"
#include "linkwright/mechanism/defects.hpp"
#include "linkwright/mechanism/six_bar_position.hpp"

namespace linkwright {

struct SixBarDriveOptions {
  /// Tell circuit defects from other branch defects: takes a walk round the whole circuit where there is a branch
  /// defect. Without it the circuit bit is never set.
  bool circuits = true;
  /// Corrections to tolerance::on_curve at every step; otherwise one of Newton's steps a step of the walk, which
  /// is as safe and four times as fast, with γ to three digits or so.
  bool exact_steps = false;
  double pose_tolerance = 1e-3;  ///< largest distance from a configuration that counts as met, radians
  int max_steps = 50'000;        ///< a walk is given up after these
};

/// Order, branch and circuit of a six-bar driven by body 1, over the configurations that it shall pass.
struct SixBarDriveReport {
  /// False: no verdict, since two strands of the curve of configurations cross or nearly do (a change point), or a
  /// loop does not close; the defects then are branch and circuit.
  bool completed = false;
  Defects defects;
  DriveSense sense = DriveSense::none;  ///< none where a defect is present
  double sweep = 0;                     ///< angle that the driver turns from first to last, radians; 0 with a defect
  /// Least SixBarTransmission::sine over the travel from the first to the last, at the steps of the walk and at the
  /// configurations themselves; 0 with a defect.
  double min_sine = 0;
  /// Dyadic six-bars: of the dyad that follows the driver, and of the one that follows that; otherwise the same twice.
  std::array<double, 2> min_sines{};
  int steps = 0;  ///< that the walk took
};

/// Drives the six-bar by body 1 through `wanted` (closed configurations in the order to be visited, the first being
/// position 1): follows the curve of configurations on the torus of the five bodies' angles by arc length with Newton
/// corrections, forwards and backwards from position 1 to the driver's dead points (the determinant of the loops by the
/// other four bodies changes sign) or until all are met, and where a configuration is missing, round the whole circuit.
/// Steps are bounded so that the walk stays on its strand (src/mechanism/six_bar_walk.cpp), whether the loops fall
/// apart into dyads or not.
[[nodiscard]] SixBarDriveReport drive_six_bar(const SixBar& six_bar, std::span<const SixBarTurns> wanted,
                                              const SixBarDriveOptions& options = {});

/// What SixBarDriveReport::min_sine cannot exceed, from the wanted configurations alone; nothing where their signs
/// tell that there is a branch defect. Cheap.
[[nodiscard]] std::optional<double> sine_upper_bound(const SixBar& six_bar, std::span<const SixBarTurns> wanted);

}  // namespace linkwright
