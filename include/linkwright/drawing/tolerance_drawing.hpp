#pragma once

#include <string>

#include "linkwright/synthesis/tolerance_measures.hpp"

namespace linkwright {

/// A study as a picture (SVG, 1000 × 800): histograms of the samples' errors in each position (of a straight line at
/// its ends and in the middle), where they lie (of a body in the plane its origin about where it is to be, of a
/// straight line the paths of some linkages made), and what contributes how much to the variance.
[[nodiscard]] std::string draw_tolerances(const ToleranceStudy& study);

}  // namespace linkwright
