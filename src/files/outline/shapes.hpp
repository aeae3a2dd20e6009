#pragma once

#include <vector>

#include "linkwright/files/outline_file.hpp"
#include "strokes.hpp"

namespace linkwright {

/// The largest shapes of a drawing: parts before open chains before frames.
[[nodiscard]] std::vector<DrawnShape> shapes_of(Strokes strokes);

/// Of a closed line so many corners that it keeps its form, 200 at most.
[[nodiscard]] std::vector<Point> simplified(const std::vector<Point>& corners);

}  // namespace linkwright
