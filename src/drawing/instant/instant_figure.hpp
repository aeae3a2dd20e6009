#pragma once

#include <string>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"

namespace linkwright {

/// What an instant shows behind a linkage: pole tangent and normal, the circles, the curves of stationary curvature.
void draw_instant_curves(SvgCanvas& svg, const PlaneWindow& window, const InstantAnalysis& analysis);

/// The inflection circle, or the line in its place.
void draw_inflection_circle(SvgCanvas& svg, const PlaneWindow& window, const Instant& instant,
                            const std::string& attributes);

/// Its points with their names, before the linkage: pole, inflection pole, Ball's and Burmester's points, acceleration
/// pole, the point that was asked for with its centre of curvature. Names keep clear of `taken` (px).
void draw_instant_points(SvgCanvas& svg, const PlaneWindow& window, const InstantAnalysis& analysis,
                         std::vector<Point> taken);

/// What the lines are, from `left` on.
void draw_instant_key(SvgCanvas& svg, Point left, const InstantAnalysis& analysis);

/// Points by which a window is laid, none farther from `center` than `reach`: what is farther runs out of the picture.
[[nodiscard]] std::vector<Point> instant_points(const InstantAnalysis& analysis, Point center, double reach);

}  // namespace linkwright
