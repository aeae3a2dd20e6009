#pragma once

#include <span>
#include <vector>

#include "linkwright/analysis/six_bar_motion.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/planar/six_bar_solution.hpp"

namespace linkwright {

/// What can be said of one six-bar as it is, driven by body 1. Angles in radians.
struct SixBarAnalysis {
  SixBarShape shape;
  std::vector<SixBarLength> lengths;
  double transmission_angle = 0;  ///< as it lies
  SixBarMotion travel;            ///< through all poses; no states where there is one only, or no such travel
  SixBarMotion motion;            ///< all that it can do: a full turn, or from dead point to dead point
};

/// `poses`: of the guided body, the first as the six-bar lies; at least one. States a degree of the driver apart or
/// less.
[[nodiscard]] SixBarAnalysis analyze(const SixBar& six_bar, std::span<const PrescribedPose> poses);

/// The travel through all poses, states a degree of the driver apart or less; without such a travel all that the
/// six-bar can do.
[[nodiscard]] SixBarMotion tabulated_motion(const SixBar& six_bar, std::span<const PrescribedPose> poses);

}  // namespace linkwright
