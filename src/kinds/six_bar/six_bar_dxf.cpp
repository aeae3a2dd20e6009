#include <algorithm>
#include <array>
#include <vector>

#include "drawing/dxf/dxf_writer.hpp"
#include "drawing/dxf_drawing.hpp"
#include "six_bar_figure.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, SixBar::bodies> layers = {"GROUND", "BODY_1", "BODY_2",
                                                                 "BODY_3", "BODY_4", "BODY_5"};
constexpr std::string_view body_path = "BODY_PATH";

std::vector<Point> corners(const SixBar& six_bar, const SixBarScene::Hinges& hinges, int body) {
  std::vector<Point> found;
  for (const std::size_t joint : six_bar.joints_of(body)) found.push_back(hinges[joint]);
  return found;
}

/// Two hinges: a bar with round ends; three: the triangle between them, with pin holes.
void draw_body(DxfWriter& dxf, std::string_view layer, const std::vector<Point>& hinges, double radius) {
  if (hinges.size() == 2) return draw_link(dxf, layer, hinges[0], hinges[1], radius);
  dxf.polyline(layer, hinges, true);
  for (const Point hinge : hinges) dxf.circle(layer, hinge, radius);
}

void draw_ground(DxfWriter& dxf, const std::vector<Point>& hinges, double radius) {
  for (const Point hinge : hinges) draw_ground_pivot(dxf, layers[0], hinge, radius);
  dxf.polyline(layers[0], hinges, hinges.size() > 2);
}

void draw_positions(DxfWriter& dxf, const SixBarScene& scene, double frame_size) {
  for (std::size_t pose = 0; pose < scene.poses.size(); ++pose)
    draw_frame(dxf, positions_layer, scene.poses[pose].pose, pose + 1, frame_size);
  for (const SixBarScene::Hinges& hinges : scene.positions)
    for (int body = 1; body < SixBar::bodies; ++body) {
      const std::vector<Point> there = corners(scene.six_bar, hinges, body);
      dxf.polyline(positions_layer, there, there.size() > 2);
    }
}

}  // namespace

std::string draw_dxf(const StoredSixBar& linkage) {
  DxfWriter dxf(insert_units(linkage.length_unit), {{layers[0], 8},
                                                    {layers[1], 5},
                                                    {layers[2], 4},
                                                    {layers[3], 7},
                                                    {layers[4], 30},
                                                    {layers[5], 6},
                                                    {positions_layer, 9},
                                                    {body_path, 3}});
  const SixBarScene scene = scene_of(linkage);
  const SixBarShape shape = shape_of(linkage.six_bar);
  const double radius = std::min(0.1 * shape.longest / shape.link_ratio, 0.015 * shape.longest);
  SixBarScene::Hinges hinges{};
  for (std::size_t joint = 0; joint < hinges.size(); ++joint) hinges[joint] = linkage.six_bar.joints[joint].point;
  draw_ground(dxf, corners(linkage.six_bar, hinges, 0), radius);
  for (int body = 1; body < SixBar::bodies; ++body)
    draw_body(dxf, layers[static_cast<std::size_t>(body)], corners(linkage.six_bar, hinges, body), radius);
  draw_positions(dxf, scene, 0.12 * shape.longest);
  dxf.polyline(body_path, scene.path.empty() ? scene.whole_path : scene.path, false);
  return dxf.file();
}

}  // namespace linkwright
