#pragma once

#include <span>

#include "linkwright/analysis/drive_through.hpp"
#include "linkwright/mechanism/prescribed_orientation.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright {

/// Drives the four-bar by its input through the orientations, slowly, as drive_through() of planar ones: traces the
/// circuit of configurations (θ, ψ) on which the coupler keeps its angle by arc-length continuation, and reads the
/// defects off; it shares nothing with find_defects(). `worst_pose_error` is the largest distance of a moving axis, on
/// the unit sphere, from where a visited orientation wants it.
[[nodiscard]] DriveThroughReport drive_through(const SphericalFourBar& four_bar,
                                               std::span<const PrescribedOrientation> orientations,
                                               const DriveThroughOptions& options = {});

}  // namespace linkwright
