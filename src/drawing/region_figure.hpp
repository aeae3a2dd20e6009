#pragma once

#include "linkwright/files/problem_file.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "plane_window.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// The solution region by type: full colour where all requirements are met, washed where only a requirement fails,
/// grey with hatching where the linkage has a defect. Up: the driving side link; right: the other, or a function's free
/// number; a map of one column lies on its side as a ribbon. Where there are only a few cells each says what it is. The
/// best linkages carry rings with their numbers. `map`: the rectangle of the cells; axes stand left of and below it.
void draw_region(SvgCanvas& svg, const Problem& problem, const Solution& solution, const PixelBox& map);

/// The map of a chain's six-bars in the same way: link 4 up, link 5 to the right.
void draw_six_bar_region(SvgCanvas& svg, const SixBarTask& task, const Solution& solution, const PixelBox& map);

/// One column only: a function without a free number.
[[nodiscard]] bool is_ribbon(const Solution& solution);

/// A few cells only: side links, or linkages, that can be counted.
[[nodiscard]] bool is_board(const Solution& solution);

/// Cells that are four-bars with four pivots.
[[nodiscard]] std::int64_t four_bars_in(const RegionCounts& counts);

/// Names, colours and counts of the types, in two columns, and what washed and hatched mean.
void draw_region_legend(SvgCanvas& svg, const Solution& solution, Point corner, double width);

}  // namespace linkwright
