#pragma once

#include <vector>

#include "approximate/curve_least_squares.hpp"
#include "approximate/scan_target.hpp"

namespace linkwright {

/// What the options ask for, in the frame in which a target is fitted.
[[nodiscard]] FitLimits scaled_limits(const CurveFitOptions& options, const ScaledTarget& target);

[[nodiscard]] CouplerLinkage in_user_frame(const CouplerLinkage& linkage, const ScaledTarget& target);

/// A curve as it is told, and as it was found.
struct FoundCurve {
  CurveFit fit;
  CouplerLinkage linkage;
};

/// Those that can be driven, distinct, the best first, and the best of those that cannot.
[[nodiscard]] CurveFits sorted_out(std::vector<FoundCurve> all, const CurveTarget& target,
                                   const CurveFitOptions& options);

}  // namespace linkwright
