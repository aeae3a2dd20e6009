#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/planar/function_task.hpp"

namespace linkwright {

/// The dials of a generator that stands at the first pair: round each ground pivot an arc over the range, with a
/// numbered mark where the link stands at each pair. `task` with its free parameter fixed.
void draw_angle_scales(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar, const FunctionTask& task);

/// Pivots of the linkage at each pair, for the window.
[[nodiscard]] std::vector<Point> angle_scale_points(const FourBar& four_bar, const FunctionTask& task);

}  // namespace linkwright
