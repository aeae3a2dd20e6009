#pragma once

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/mechanism/four_bar.hpp"

namespace linkwright {

/// The lengths of the four links, each beside its link where it is clearest of the other links, pivots and lengths.
void draw_dimensions(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar);

}  // namespace linkwright
