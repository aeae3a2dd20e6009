#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/pose_conditions.hpp"
#include "linkwright/region/requirements.hpp"
#include "linkwright/synthesis/answer.hpp"

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

/// A place that a point passes: a disc with its number. `strong`: the first.
void draw_place(SvgCanvas& svg, const PlaneWindow& window, Point point, std::size_t number, bool strong);

/// The moving frame in a pose: a disc with the pose's number, x and y arms. `strong`: position 1.
void draw_pose(SvgCanvas& svg, const PlaneWindow& window, const Pose& pose, std::size_t number, bool strong);

/// A bar of a round length with its name, its left end at `left`.
void draw_scale_bar(SvgCanvas& svg, const PlaneWindow& window, Point left, std::string_view unit);

/// A sample of a line with its name, and where the next entry starts.
double draw_line_key(SvgCanvas& svg, Point left, std::string_view attributes, std::string_view name);

/// px from where an entry starts to where the next one does.
[[nodiscard]] double line_key_width(std::string_view name);

/// The lengths of the four links, each beside its link where it is clearest of the other links, pivots and lengths.
void draw_dimensions(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar);

/// The dials of a generator that stands at the first pair: round each ground pivot an arc over the range, with a
/// numbered mark where the link stands at each pair. `task` with its free parameter fixed.
void draw_angle_scales(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar, const FunctionTask& task);

/// Pivots of the linkage at each pair, for the window.
[[nodiscard]] std::vector<Point> angle_scale_points(const FourBar& four_bar, const FunctionTask& task);

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

/// A white card with a heading.
void draw_card(SvgCanvas& svg, const PixelBox& card, std::string_view heading);

/// A text in lines of about `width` px, at most `lines` of them; they lie one and a half sizes apart.
void draw_wrapped(SvgCanvas& svg, Point position, std::string_view text, double width, int lines, double size = 15);

/// The type with its colour.
void draw_type_name(SvgCanvas& svg, Point corner, LinkageType type);
/// The same, and the least transmission angle over the task or that there is a defect.
void draw_type(SvgCanvas& svg, Point corner, const DefectReport& report);
/// "71.8° counter-clockwise": what the input turns through, "–" with a defect.
[[nodiscard]] std::string rotation_text(const DefectReport& report);

/// Rows of the link lengths and of the pivots with the colours of their roles, `corner` the upper left one of a card;
/// `position`: in which the moving pivots lie, from 1.
void draw_length_rows(SvgCanvas& svg, Point corner, double width, const LinkLengths& lengths, std::string_view unit);
void draw_pivot_rows(SvgCanvas& svg, Point corner, double width, const FourBar& four_bar, int position = 1);

/// A wide, low card with the numbers of the best linkage: type, transmission angle, lengths, pivots, checks.
void draw_linkage_strip(SvgCanvas& svg, const PixelBox& card, const FourBarAnswer& answer, std::string_view unit);

/// The same card where there is no linkage: why, and the ways out of five positions.
void draw_reason_strip(SvgCanvas& svg, const PixelBox& card, const MotionAnswer& answer, std::string_view unit);
void draw_reason_strip(SvgCanvas& svg, const PixelBox& card, const FourBarAnswer& answer, std::string_view unit);

/// The four-bar, given as it lies in the first of the poses, as it lies in another one.
[[nodiscard]] FourBar in_pose(const FourBar& four_bar, std::span<const PrescribedPose> poses, std::size_t pose);

/// A linkage of a file by its positions, as it moves: where it comes nearest to each, and on another circuit as it
/// would be assembled there.
[[nodiscard]] std::vector<FourBar> in_positions(const StoredLinkage& linkage);

/// The traced point's way from the first pose to the last, driven as the task wants; empty where a defect forbids it
/// and of a single pose.
[[nodiscard]] std::vector<Point> path_of_task(const FourBar& four_bar, std::span<const PrescribedPose> poses,
                                              Point traced);

/// The traced point's way over the whole motion cycle.
[[nodiscard]] std::vector<Point> path_of_cycle(const FourBar& four_bar, Point traced);

}  // namespace linkwright
