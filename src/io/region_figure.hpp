#pragma once

#include "linkwright/planar/synthesis.hpp"
#include "plane_window.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// The solution region by type: full colour where all requirements are met, washed where only a requirement fails,
/// grey with hatching where the linkage has a defect. Up: the driving side link's place on its curve; right: the
/// other's. The best linkages carry rings with their numbers. `map`: the square of the cells; axes stand left of and
/// below it.
void draw_region(SvgCanvas& svg, const Solution& solution, const PixelBox& map);

/// Cells that are four-bars with four pivots.
[[nodiscard]] std::int64_t four_bars_in(const RegionCounts& counts);

/// Names, colours and counts of the types, in two columns, and what washed and hatched mean.
void draw_region_legend(SvgCanvas& svg, const Solution& solution, Point corner, double width);

}  // namespace linkwright
