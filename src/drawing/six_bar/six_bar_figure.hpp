#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "drawing/plane_window.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkwright/files/six_bar_file.hpp"

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

}  // namespace linkwright
