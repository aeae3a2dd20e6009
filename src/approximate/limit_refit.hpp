#pragma once

#include "approximate/timed_least_squares.hpp"

namespace linkwright {

/// By how much a linkage breaks its limits, as a share of each; 0 where it keeps them. Of the transmission angle the
/// sine, at the states, where the start has a branch.
[[nodiscard]] double broken_share(const FitLimits& limits, const CurveStart& start);

/// Hinges give way a little: limits that are broken are set a little stricter, pivots outside their window are moved to
/// its border and held there, and the rest is fitted again.
void refit_within_limits(const FitTask& task, CurveStart& start);
void refit_within_limits(const TimedTask& task, TimedStart& start);

/// Weights are shifted towards the largest distances until the largest is least (C. L. Lawson, 1961), at least that of
/// all that were met. The task's weights tell which points count.
void fit_least_largest(const FitTask& task, CurveStart& start);
void fit_least_largest(const TimedTask& task, TimedStart& start);

}  // namespace linkwright
