#include "point_marks.hpp"

#include <algorithm>

#include "linkwright/core/angle.hpp"
#include "palette.hpp"

namespace linkwright {

bool PointMarks::is_seen(Point px) const {
  const PixelBox& box = window_.box();
  return px.real() >= box.left && px.real() <= box.right() && px.imag() >= box.top && px.imag() <= box.bottom();
}

void PointMarks::add(Point at, std::string name, std::string_view color) {
  const Point px = window_.to_px(at);
  if (!is_seen(px)) return;
  svg_.circle(px, 4.5, fill(color) + " " + stroke(palette::paper, 1.6));
  taken_.push_back(px);
  named_.push_back({px, std::move(name), color});
}

void PointMarks::square(Point at, std::string_view color) {
  const Point px = window_.to_px(at);
  if (!is_seen(px)) return;
  draw_square_mark(svg_, px, color);
  taken_.push_back(px);
}

void PointMarks::name_only(Point at, std::string name, std::string_view color) {
  const Point px = window_.to_px(at);
  if (is_seen(px)) named_.push_back({px, std::move(name), color});
}

void PointMarks::name() {
  PointNames names(taken_);
  for (const Named& mark : named_) names.draw(svg_, mark.px, mark.name, mark.color);
}

void draw_square_mark(SvgCanvas& svg, Point px, std::string_view color) {
  constexpr double half = 4.2;
  svg.rectangle(px - Point{half, half}, 2 * half, 2 * half, fill(color) + " " + stroke(palette::paper, 1.4));
}

void PointNames::draw(SvgCanvas& svg, Point pin, std::string_view name, std::string_view color) {
  constexpr double distance = 17, size = 13;
  Point best = pin;
  double best_room = -1;
  for (int i = 0; i < 16; ++i) {
    const Point place = pin + distance * direction(two_pi * i / 16);
    double room = 1e9;
    for (const Point obstacle : obstacles_) room = std::min(room, std::abs(obstacle - place));
    if (room <= best_room) continue;
    best_room = room;
    best = place;
  }
  obstacles_.push_back(best);
  svg.text(best + Point{0, 0.36 * size}, name,
           {.size = size, .color = color, .anchor = "middle", .weight = 650, .halo = palette::paper});
}

}  // namespace linkwright
