#pragma once

#include <string_view>

#include "linkwright/planar/synthesis.hpp"
#include "plane_window.hpp"
#include "svg_canvas.hpp"

namespace linkwright {

/// A white card with a heading.
void draw_card(SvgCanvas& svg, const PixelBox& card, std::string_view heading);

/// A text in lines of about `width` px, at most `lines` of them.
void draw_wrapped(SvgCanvas& svg, Point position, std::string_view text, double width, int lines);

/// Rows of the link lengths and of the pivots with the colours of their roles, `corner` the upper left one of a card.
void draw_length_rows(SvgCanvas& svg, Point corner, double width, const LinkLengths& lengths, std::string_view unit);
void draw_pivot_rows(SvgCanvas& svg, Point corner, double width, const FourBar& four_bar);

/// A wide, low card with the numbers of one linkage: type, transmission angle, lengths, pivots, checks.
void draw_linkage_strip(SvgCanvas& svg, const PixelBox& card, const FourBarSolution& found, std::string_view unit);

}  // namespace linkwright
