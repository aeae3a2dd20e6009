#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/algebra/directed_line.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// A linkage whose point runs along a line, as pictures show it; fixed frame.
struct LineScene {
  TracingFourBar linkage;            ///< as it lies
  DirectedLine line;                 ///< along which its point runs
  std::vector<Point> whole_path;     ///< of the point, over the motion cycle
  std::vector<Point> usable;         ///< the straight stretch of it
  std::vector<TracingFourBar> ends;  ///< the linkage at both ends of that
  InstantAnalysis instant;           ///< of the coupler as it lies
};

[[nodiscard]] LineScene line_scene(const StraightLineSolution& found, LineMeasure measure);
/// Of a linkage alone: the line is the tangent of its path, the stretch within LineMeasuring::default_share of the
/// longest link of it.
[[nodiscard]] LineScene line_scene(const TracingFourBar& linkage);

/// By what a window is laid: the linkage, the stretch and both its ends, and of the path, of the inflection circle and
/// the pole what is not far off.
[[nodiscard]] std::vector<Point> points_of_interest(const LineScene& scene);

/// The line across the window.
void draw_wanted_line(SvgCanvas& svg, const PlaneWindow& window, const DirectedLine& line);

/// What lies behind the linkage: inflection circle, line, path, the linkage at the ends of the stretch, its coupler.
void draw_line_background(SvgCanvas& svg, const PlaneWindow& window, const LineScene& scene);
/// The linkage itself, and before it the points with their names.
void draw_tracing_linkage(SvgCanvas& svg, const PlaneWindow& window, const LineScene& scene);

/// The linkage small, without names.
void draw_small_scene(SvgCanvas& svg, const PixelBox& box, const LineScene& scene);

/// What the lines are, the last entry ending at `right`.
void draw_line_keys(SvgCanvas& svg, Point right);

/// The deviation of a linkage's point from its line over the way along the line, magnified: the strip within which its
/// length counts as usable, the ends of that, where the linkage lies and, of contacts at places, those. `box`: of the
/// curve; numbers stand left of it, right of it and below it (44, 34 and 34 px), the heading above (18 px).
void draw_deviation_plot(SvgCanvas& svg, const PixelBox& box, const StraightLineSolution& found, LineMeasure measure,
                         std::string_view length_unit);

}  // namespace linkwright
