#pragma once

#include <string_view>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// The best linkages small, side by side in a rectangle of a picture, each with what it is and its usable length: as
/// many as can be told apart there.
void draw_gallery(SvgCanvas& svg, const PixelBox& box, const StraightLineAnswer& answer, std::string_view length_unit);

}  // namespace linkwright
