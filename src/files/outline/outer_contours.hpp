#pragma once

#include <vector>

#include "strokes.hpp"

namespace linkwright {

/// The closed lines around all that hangs together where ends of chains meet, no farther apart than `reach`: lines
/// within, as those along which a sheet is folded, do not cut them, whatever the order of the chains.
[[nodiscard]] std::vector<Stroke> outer_contours(const std::vector<Stroke>& chains, double reach);

}  // namespace linkwright
