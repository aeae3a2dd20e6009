#include "space_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/palette.hpp"
#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr double azimuth = 0.62, elevation = 0.42;  // of the one who looks: 36° from x towards y, 24° up
constexpr double sample_px = 3;                     // between the points of a line that labels keep clear of

std::vector<Point> seen_by(std::span<const Vector3> points) {
  std::vector<Point> plane;
  plane.reserve(points.size());
  for (const Vector3 r : points) plane.push_back(seen(r));
  return plane;
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

bool inside(const PixelBox& box, Point p) {
  return p.real() > box.left && p.real() < box.right() && p.imag() > box.top && p.imag() < box.bottom();
}

Point unit(Point p) { return std::abs(p) > 1e-9 ? p / std::abs(p) : Point{0, -1}; }

}  // namespace

Point seen(Vector3 r) {
  const Vector3 right{-std::sin(azimuth), std::cos(azimuth), 0};
  const Vector3 up{-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth),
                   std::cos(elevation)};
  return {dot(right, r), dot(up, r)};
}

Vector3 towards_viewer() {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

std::vector<Vector3> helix(Vector3 center, Vector3 axis, Vector3 from, double angle, double slide) {
  const int steps = std::clamp(static_cast<int>(std::ceil(std::abs(angle) / (pi / 36))), 1, 2000);
  const Vector3 along = dot(axis, from) * axis, across = from - along, beside = cross(axis, across);
  std::vector<Vector3> points;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps, turned = share * angle;
    points.push_back(center + along + std::cos(turned) * across + std::sin(turned) * beside + (share * slide) * axis);
  }
  return points;
}

SpaceFigure::SpaceFigure(SvgCanvas& svg, const PixelBox& box, std::span<const Vector3> points, double margin)
    : svg_(&svg), window_(box, seen_by(points), margin) {}

void SpaceFigure::keep_clear(Point from, Point to) {
  const int steps = std::clamp(static_cast<int>(std::abs(to - from) / sample_px), 1, 400);
  for (int i = 0; i <= steps; ++i) obstacles_.push_back(from + (static_cast<double>(i) / steps) * (to - from));
}

void SpaceFigure::line(Vector3 from, Vector3 to, std::string_view color, double width, std::string_view dashes) {
  const std::array<Vector3, 2> ends = {from, to};
  path(ends, color, width, dashes);
}

void SpaceFigure::path(std::span<const Vector3> points, std::string_view color, double width, std::string_view dashes) {
  std::vector<Point> px;
  for (const Vector3 r : points) px.push_back(to_px(r));
  for (std::size_t i = 0; i + 1 < px.size(); ++i) keep_clear(px[i], px[i + 1]);
  svg_->polyline(px, stroke(color, width, dashes) + " stroke-linecap=\"round\" stroke-linejoin=\"round\"");
}

void SpaceFigure::head(Point tip, Point direction, std::string_view color, double width) {
  const double length = 5 + 2.2 * width;
  const Point back = tip - length * direction, side = 0.42 * length * Point{-direction.imag(), direction.real()};
  const std::array<Point, 3> corners = {tip, back + side, back - side};
  svg_->polygon(corners, fill(color));
}

void SpaceFigure::arrow(Vector3 from, Vector3 to, std::string_view color, double width, std::string_view dashes) {
  const Point tail = to_px(from), tip = to_px(to);
  const double head_length = 5 + 2.2 * width;
  keep_clear(tail, tip);
  if (std::abs(tip - tail) < head_length) {  // it points at the one who looks, or away
    svg_->circle(tip, 2 + width, fill(color));
    return;
  }
  const Point direction = unit(tip - tail);
  svg_->line(tail, tip - 0.8 * head_length * direction, stroke(color, width, dashes) + " stroke-linecap=\"round\"");
  head(tip, direction, color, width);
}

void SpaceFigure::arrow_along(std::span<const Vector3> points, std::string_view color, double width) {
  path(points, color, width);
  if (points.size() < 2) return;
  const Point tip = to_px(points.back());
  std::size_t before = points.size() - 1;
  while (before > 0 && std::abs(tip - to_px(points[before])) < 6) --before;
  const Point way = tip - to_px(points[before]);
  if (std::abs(way) > 4) head(tip, unit(way), color, width);
}

void SpaceFigure::sector(Vector3 center, std::span<const Vector3> rim, std::string_view color) {
  std::vector<Point> px = {to_px(center)};
  for (const Vector3 r : rim) px.push_back(to_px(r));
  svg_->polygon(px, fill(color, 0.13));
}

void SpaceFigure::dot(Vector3 at, std::string_view color) {
  const Point px = to_px(at);
  keep_clear(px, px);
  svg_->circle(px, 3.2, fill(color));
}

void SpaceFigure::triad(const Displacement& frame, double length, std::string_view color, double width,
                        const std::array<std::string, 3>& names) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 axis = frame.apply_to_direction(unit_vector(static_cast<Axis>(k)));
    const Vector3 tip = frame.translation + length * axis;
    arrow(frame.translation, tip, color, width);
    label(tip, names[k], color, frame.translation);
  }
}

void SpaceFigure::label(Vector3 at, std::string text, std::string_view color, Vector3 from, double size) {
  if (text.empty()) return;
  const Point px = to_px(at);
  labels_.push_back({px, unit(px - to_px(from)), std::move(text), color, size});
}

double SpaceFigure::cost(const PixelBox& box, const std::vector<PixelBox>& taken) const {
  double total = 0;
  for (const PixelBox& other : taken) total += overlap(box, other) ? 1000 : 0;
  const PixelBox& room = window_.box();
  if (box.left < room.left || box.right() > room.right() || box.top < room.top || box.bottom() > room.bottom())
    total += 1000;
  for (const Point p : obstacles_) total += inside(box, p) ? 6 : 0;
  return total;
}

/// The cheapest of places round the label's anchor: near, to the preferred side, off lines, clear of other labels.
PixelBox SpaceFigure::place(const Label& label, const std::vector<PixelBox>& taken) const {
  const double width = text_width(label.text, label.size) + 4, height = 1.15 * label.size;
  PixelBox best;
  double least = std::numeric_limits<double>::infinity();
  for (const double gap : {4.0, 9.0, 16.0, 26.0, 40.0}) {
    for (int turn = 0; turn <= 23; ++turn) {
      const int steps = (turn + 1) / 2;  // 0, 1, 1, 2, 2, … to either side in turn
      const double angle = (turn % 2 == 0 ? 1 : -1) * steps * (pi / 12);
      const Point way = label.away * direction(angle);
      const Point center = label.at + Point{way.real() * (gap + width / 2), way.imag() * (gap + height / 2)};
      const PixelBox box{center.real() - width / 2, center.imag() - height / 2, width, height};
      const double total = cost(box, taken) + 0.8 * gap + 6 * std::abs(angle);
      if (total >= least) continue;
      least = total;
      best = box;
    }
  }
  return best;
}

void SpaceFigure::finish() {
  std::vector<PixelBox> taken;
  for (const Label& label : labels_) {
    const PixelBox box = place(label, taken);
    taken.push_back(box);
    svg_->text({box.left + box.width / 2, box.top + box.height / 2 + 0.35 * label.size}, label.text,
               {.size = label.size, .color = label.color, .anchor = "middle", .weight = 600, .halo = palette::paper});
  }
}

std::string degrees_text(double angle) { return significant_text(degrees(angle), 5) + "°"; }

}  // namespace linkwright
