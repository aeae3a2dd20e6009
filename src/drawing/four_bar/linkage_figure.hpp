#pragma once

#include <span>
#include <string>
#include <string_view>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

// The parts of a drawing of a linkage, from back to front. All sizes in px, the same at every scale.

/// Triangle, base line and hatch strokes below a fixed pivot (px).
void draw_ground_symbol(SvgCanvas& svg, Point pivot);
/// A link with two hinges (px), and the pin of a hinge.
void draw_link(SvgCanvas& svg, Point from, Point to, std::string_view color);
void draw_pin(SvgCanvas& svg, Point pivot, std::string_view color);

void draw_grid(SvgCanvas& svg, const PlaneWindow& window);

/// A dotted rectangle with its name in the lower right corner, or in the upper right one.
enum class BoxName { below, above };
void draw_box(SvgCanvas& svg, const PlaneWindow& window, const Box& box, std::string_view name,
              BoxName place = BoxName::below);

/// A path in px, dotted, in the accent colour: the task's stretch, or thinner what lies beyond it.
void draw_traced_path(SvgCanvas& svg, const PlaneWindow& window, std::span<const Point> path, bool is_task);

/// The grounded links and the coupler as thin lines.
void draw_ghost(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar);

/// The coupler as a body that carries the moving frame.
void draw_body(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar, Point frame_origin);

/// Links and ground symbols in the colours of their roles.
void draw_bars(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar);

/// The pins of the four pivots; poses go between bars and pins, so that neither hides the other.
void draw_pins(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar);

/// The direction of travel through a pose with derivatives, beneath the frame: an arrow along which its origin leaves,
/// or one bent round the origin where that hardly moves.
void draw_direction(SvgCanvas& svg, const PlaneWindow& window, const PrescribedPose& pose);

/// The moving frame in a pose: a disc with the pose's number, x and y arms. `strong`: position 1.
void draw_pose(SvgCanvas& svg, const PlaneWindow& window, const Pose& pose, std::size_t number, bool strong);

/// A bar of a round length with its name, its left end at `left`.
void draw_scale_bar(SvgCanvas& svg, const PlaneWindow& window, Point left, std::string_view unit);

/// A sample of a line with its name, and where the next entry starts.
double draw_line_key(SvgCanvas& svg, Point left, std::string_view attributes, std::string_view name);

/// px from where an entry starts to where the next one does.
[[nodiscard]] double line_key_width(std::string_view name);

}  // namespace linkwright
