#include <fmt/format.h>

#include "dxf_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"

namespace linkwright {

int insert_units(std::string_view unit) {
  constexpr int unitless = 0;
  const auto known = length_unit(unit);
  return known ? known->insunits : unitless;
}

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

void draw_ground_pivot(DxfWriter& dxf, std::string_view layer, Point pivot, double radius) {
  const Point foot_left = pivot + radius * Point{-3, -5}, foot_right = pivot + radius * Point{3, -5};
  dxf.circle(layer, pivot, radius);
  dxf.line(layer, pivot + radius * Point{-1, 0}, foot_left);
  dxf.line(layer, pivot + radius * Point{1, 0}, foot_right);
  dxf.line(layer, foot_left + radius * Point{-1, 0}, foot_right + radius * Point{1, 0});
}

void draw_frame(DxfWriter& dxf, std::string_view layer, const Pose& pose, std::size_t number, double size) {
  dxf.line(layer, pose.origin, pose.origin + size * direction(pose.angle));
  dxf.line(layer, pose.origin, pose.origin + 0.6 * size * direction(pose.angle + pi / 2));
  dxf.text(layer, pose.origin + 0.15 * size * Point{1, 1}, 0.3 * size, fmt::format("{}", number));
}

}  // namespace linkwright
