#pragma once

#include <optional>

#include "linkwright/approximate/fit_wishes.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// Looks for the linkages of a problem without mistakes with as much effort as is said instead of its own; nothing
/// where they are not fitted. Evidence, no proof, as fit_curve() and fit_poses() say.
[[nodiscard]] std::optional<FitSearch> search_fits(const Problem& problem, FitEffort effort,
                                                   const Progress& progress = {});

}  // namespace linkwright
