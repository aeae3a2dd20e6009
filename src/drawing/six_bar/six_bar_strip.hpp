#pragma once

#include <string>
#include <string_view>

#include "drawing/svg_canvas.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// Rows of hinges [from, to) with the bodies that they join, and of lengths [from, to), `corner` the upper left one of
/// a card.
void draw_hinge_rows(SvgCanvas& svg, Point corner, double width, const SixBar& six_bar, std::size_t from,
                     std::size_t to);
void draw_length_rows(SvgCanvas& svg, Point corner, double width, const SixBar& six_bar, std::size_t from,
                      std::size_t to);

/// A row of each body: colour, what it is, its hinges.
void draw_body_rows(SvgCanvas& svg, Point corner, double width, const SixBar& six_bar);

/// A row of each six-bar with its numbers, the heading first.
void draw_six_bar_table(SvgCanvas& svg, Point corner, double width, const SixBarAnswer& answer);

/// "32.1° counter-clockwise", "–".
[[nodiscard]] std::string drive_text(const SixBarDriveReport& drive);

}  // namespace linkwright
