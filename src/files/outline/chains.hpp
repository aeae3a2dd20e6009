#pragma once

#include <vector>

#include "strokes.hpp"

namespace linkwright {

/// Closed strokes; open ones joined where just two ends meet; and the outer contours of what hangs together at places
/// where more do. Ends meet that lie no farther apart than 1e-5 of the drawing's size.
[[nodiscard]] std::vector<Stroke> chained(std::vector<Stroke> strokes);

}  // namespace linkwright
