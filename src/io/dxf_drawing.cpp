#include "linkwright/io/dxf_drawing.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "dxf_writer.hpp"
#include "linkage_positions.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/io/csv_table.hpp"

namespace linkwright {
namespace {

constexpr std::string_view ground = "GROUND", input = "INPUT", coupler = "COUPLER", output = "OUTPUT",
                           positions = "POSITIONS", coupler_curve = "COUPLER_CURVE";

/// $INSUNITS of a length unit.
int insert_units(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, int>, 9> known = {
      {{"mm", 4}, {"cm", 5}, {"m", 6}, {"in", 1}, {"inch", 1}, {"\"", 1}, {"ft", 2}, {"dm", 14}, {"km", 7}}};
  const auto found = std::find_if(known.begin(), known.end(), [&](const auto& entry) { return entry.first == unit; });
  return found == known.end() ? 0 : found->second;
}

/// Radius of the pin holes: small against the shortest link, visible against the longest.
double pin_radius(const LinkLengths& lengths) { return std::min(0.1 * lengths.shortest(), 0.015 * lengths.longest()); }

/// A link: an outline with round ends, and the holes of its pins.
void draw_link(DxfWriter& dxf, std::string_view layer, Point from, Point to, double radius) {
  const double outline = 2 * radius, angle = std::arg(to - from);
  const Point side = outline * direction(angle + pi / 2);
  dxf.line(layer, from + side, to + side);
  dxf.line(layer, from - side, to - side);
  dxf.arc(layer, from, outline, angle + pi / 2, angle + 3 * pi / 2);
  dxf.arc(layer, to, outline, angle - pi / 2, angle + pi / 2);
  dxf.circle(layer, from, radius);
  dxf.circle(layer, to, radius);
}

void draw_ground(DxfWriter& dxf, const FourBar& bars, double radius) {
  for (const Point pivot : {bars.input_center, bars.output_center}) {
    const Point foot_left = pivot + radius * Point{-3, -5}, foot_right = pivot + radius * Point{3, -5};
    dxf.circle(ground, pivot, radius);
    dxf.line(ground, pivot + radius * Point{-1, 0}, foot_left);
    dxf.line(ground, pivot + radius * Point{1, 0}, foot_right);
    dxf.line(ground, foot_left + radius * Point{-1, 0}, foot_right + radius * Point{1, 0});
  }
  dxf.line(ground, bars.input_center, bars.output_center);
}

void draw_frame(DxfWriter& dxf, const Pose& pose, std::size_t number, double size) {
  dxf.line(positions, pose.origin, pose.origin + size * direction(pose.angle));
  dxf.line(positions, pose.origin, pose.origin + 0.6 * size * direction(pose.angle + pi / 2));
  dxf.text(positions, pose.origin + 0.15 * size * Point{1, 1}, 0.3 * size, fmt::format("{}", number));
}

void draw_positions(DxfWriter& dxf, const StoredLinkage& linkage, double frame_size) {
  for (std::size_t pose = 0; pose < linkage.poses.size(); ++pose) {
    draw_frame(dxf, linkage.poses[pose].pose, pose + 1, frame_size);
    if (pose == 0) continue;
    const FourBar bars = in_pose(linkage.four_bar, linkage.poses, pose);
    const std::array<Point, 4> links = {bars.input_center, bars.input_circle, bars.output_circle, bars.output_center};
    dxf.polyline(positions, links, false);
  }
}

void draw_coupler_curve(DxfWriter& dxf, const StoredLinkage& linkage) {
  std::vector<Point> path = path_of_cycle(linkage.four_bar, traced_point(linkage));
  if (path.size() > 2) path.pop_back();  // the first point again
  dxf.polyline(coupler_curve, path, true);
}

}  // namespace

std::string draw_dxf(const StoredLinkage& linkage) {
  DxfWriter dxf(insert_units(linkage.length_unit),
                {{ground, 8}, {input, 5}, {coupler, 7}, {output, 30}, {positions, 9}, {coupler_curve, 3}});
  const FourBar& bars = linkage.four_bar;
  const LinkLengths lengths = bars.lengths();
  const double radius = pin_radius(lengths);
  draw_ground(dxf, bars, radius);
  draw_link(dxf, input, bars.input_center, bars.input_circle, radius);
  draw_link(dxf, coupler, bars.input_circle, bars.output_circle, radius);
  draw_link(dxf, output, bars.output_center, bars.output_circle, radius);
  draw_positions(dxf, linkage, 0.12 * lengths.longest());
  draw_coupler_curve(dxf, linkage);
  return dxf.file();
}

}  // namespace linkwright
