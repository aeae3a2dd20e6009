#pragma once

#include <span>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/mechanism/dyad.hpp"
#include "linkwright/planar/pose_conditions.hpp"

namespace linkwright {

// The few grounded links of five positions as beads: an open one for the fixed pivot, a full one for the moving pivot
// in position 1, with the number of the grounded link. Dyads in the fixed frame; a pivot at infinity has none.

/// The links between the beads, which go behind the linkage.
void draw_bead_links(SvgCanvas& svg, const PlaneWindow& window, const WorkingFrame& frame, std::span<const Dyad> dyads);

/// Beads and numbers; the numbers keep clear of each other and of `taken` (px).
void draw_beads(SvgCanvas& svg, const PlaneWindow& window, const WorkingFrame& frame, std::span<const Dyad> dyads,
                std::vector<Point> taken);

/// What the beads are, and where the next entry starts.
double draw_bead_key(SvgCanvas& svg, Point left);
[[nodiscard]] double bead_key_width();

/// The finite pivots of a dyad in the fixed frame.
[[nodiscard]] std::vector<Point> finite_pivots(const Dyad& dyad, const WorkingFrame& frame);

}  // namespace linkwright
