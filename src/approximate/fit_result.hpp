#pragma once

#include <span>

#include "approximate/coupler_linkage.hpp"
#include "approximate/fit_limits.hpp"
#include "approximate/scan_target.hpp"
#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright {

/// Which realisation is told first: the one that is best to be driven, or that which is given.
enum class FirstRealisation : std::uint8_t { best, as_given };

/// All that is told of a curve, by a linkage that traces it and its states at the points; user's frame and unit.
[[nodiscard]] CurveFit curve_fit_of(const CouplerLinkage& linkage, std::span<const LoopState> states,
                                    const CurveTarget& target, const CurveFitOptions& options, FirstRealisation choice);

/// Asserts what a CurveTarget is to be.
void require_curve_target(const CurveTarget& target);

/// What the options ask for, in a unit of which `diagonal` is that of the target. Windows are left out: they have a
/// frame.
[[nodiscard]] FitLimits limits_of(const CurveFitOptions& options, bool closed, double diagonal);

/// The same and the window of the fixed pivots, in the frame in which the target is fitted.
[[nodiscard]] FitLimits scaled_limits(const CurveFitOptions& options, const ScaledTarget& target);
/// A linkage of that frame.
[[nodiscard]] CouplerLinkage in_user_frame(const CouplerLinkage& linkage, const ScaledTarget& target);

}  // namespace linkwright
