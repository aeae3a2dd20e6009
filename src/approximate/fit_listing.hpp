#pragma once

#include <vector>

#include "approximate/coupler_linkage.hpp"
#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright {

/// A curve as it is told, and as it was found.
struct FoundCurve {
  CurveFit fit;
  CouplerLinkage linkage;
  bool is_given = false;  ///< as it was to begin with: it is listed where it is the best
};

/// Those that can be driven, distinct, the best first, and the best of those that cannot.
[[nodiscard]] CurveFits sorted_out(std::vector<FoundCurve> all, const CurveTarget& target,
                                   const CurveFitOptions& options);

}  // namespace linkwright
