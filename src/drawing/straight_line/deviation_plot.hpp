#pragma once

#include <string_view>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"

namespace linkwright {

/// The deviation of a linkage's point from its line over the way along the line, magnified: the strip within which its
/// length counts as usable, the ends of that, where the linkage lies and, of contacts at places, those. `box`: of the
/// curve; numbers stand left of it, right of it and below it (44, 34 and 34 px), the heading above (18 px).
void draw_deviation_plot(SvgCanvas& svg, const PixelBox& box, const StraightLineSolution& found, LineMeasure measure,
                         std::string_view length_unit);

}  // namespace linkwright
