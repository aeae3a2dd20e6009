#pragma once

#include <string>
#include <string_view>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

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
void draw_reason_strip(SvgCanvas& svg, const PixelBox& card, const FunctionAnswer& answer, std::string_view unit);

}  // namespace linkwright
