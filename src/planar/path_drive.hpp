#pragma once

#include <span>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// What turning the crank showed. It knows the pivots and the point, and nothing of how they were found.
struct PathDrive {
  bool passes = false;       ///< the crank got to every point in its sense, the point being there and going its way
  bool turns_fully = false;  ///< the crank went on through a whole turn, and the point came back to where it began
  // Over the points that the crank got to.
  double position_error = 0;   ///< largest distance of the point from where it is to be, user's unit
  double timing_error = 0;     ///< largest turn of the crank from there to where the point is nearest, radians
  double direction_error = 0;  ///< largest angle between the point's way and the first derivative, radians in [0, π]
};

/// Turns the crank of bars that lie in the first position in small steps, in the sense of the angles, the output's
/// moving pivot being carried on as the nearer of the two places that its links leave it; where they leave none, the
/// crank stops. `crank_poses`: as of a PathTask without mistakes, user's frame. `tolerance`: distance that counts as
/// being there.
[[nodiscard]] PathDrive drive_along_path(const FourBar& bars, Point point, std::span<const PrescribedPose> crank_poses,
                                         double tolerance);

}  // namespace linkwright
