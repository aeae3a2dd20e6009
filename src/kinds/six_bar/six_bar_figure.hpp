#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

/// What a drawing shows of a six-bar, user's frame.
struct SixBarScene {
  using Hinges = std::array<Point, SixBar::joint_count>;

  SixBar six_bar;
  std::vector<PrescribedPose> poses;
  std::vector<Hinges> positions;  ///< in the poses after the first; none where the chain does not come there
  std::vector<Point> path;        ///< of the frame's origin, through the poses
  std::vector<Point> whole_path;  ///< over all that the six-bar can do
};
[[nodiscard]] SixBarScene scene_of(const SixBarSolution& found, const std::vector<PrescribedPose>& poses);
[[nodiscard]] SixBarScene scene_of(const StoredSixBar& linkage);

/// All that must be seen of it.
[[nodiscard]] std::vector<Point> points_of_interest(const SixBarScene& scene);

/// Colour of a body: the driver's, the link's between, the guided body's, those of the added links; 0: the ground's.
[[nodiscard]] std::string_view body_color(int body);

/// Paths, other positions, ground, links, poses, pins and the hinges' names, from back to front.
void draw_six_bar(SvgCanvas& svg, const PlaneWindow& window, const SixBarScene& scene);

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
