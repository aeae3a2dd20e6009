#include "point_names.hpp"

#include <algorithm>

#include "linkwright/core/angle.hpp"
#include "palette.hpp"

namespace linkwright {

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
