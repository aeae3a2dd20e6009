#include <algorithm>
#include <cmath>

#include "drawn_kinds.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

/// A smooth loop of a few harmonics, a part of it or a scatter, at shares of a turn.
std::vector<Point> drawn_curve(Draw& draw, int count, bool closed) {
  const int harmonics = draw.whole(1, 4);
  const double part = closed ? 1 : draw.between(0.1, 0.9);
  std::vector<Point> left, right;
  for (int k = 1; k <= harmonics; ++k) {
    left.push_back(draw.point(1.0 / (k * k)));
    right.push_back(draw.point(1.0 / (k * k)));
  }
  std::vector<Point> points;
  for (int j = 0; j < count; ++j) {
    const double turn = two_pi * part * j / count;
    Point at{};
    for (int k = 1; k <= harmonics; ++k) {
      at += left[static_cast<std::size_t>(k - 1)] * direction(k * turn);
      at += right[static_cast<std::size_t>(k - 1)] * direction(-k * turn);
    }
    points.push_back(at);
  }
  return points;
}

void spoil(Draw& draw, std::vector<Point>& points) {
  const double noise = draw.chance(0.4) ? draw.power_of_ten(-6, -0.5) : 0;
  for (Point& point : points) point += noise * draw.point(1);
  if (draw.chance(0.15))
    for (std::size_t j = 1; j < points.size(); j += 3) points[j] = points[j - 1];  // doubled
  if (draw.chance(0.2)) std::reverse(points.begin(), points.end());
  if (draw.chance(0.1)) points.push_back(points.front());
  if (draw.chance(0.05))
    for (Point& point : points) point = draw.point(1);
}

/// Rising or falling within a turn, evenly or not.
void add_timing(Draw& draw, bool closed, Json& points) {
  const double sense = draw.chance(0.5) ? 1 : -1, whole = closed ? 359 : draw.between(20, 350);
  const bool even = draw.chance(0.6);
  const double step = whole / static_cast<double>(points.size());
  double at = draw.chance(0.5) ? 0 : draw.between(-180, 180);
  for (Json& point : points) {
    point["input_deg"] = at;
    at += sense * step * (even ? 1 : draw.between(0.1, 1));
  }
}

}  // namespace

Json drawn_near_path(Draw& draw, const Sheet& sheet) {
  Json task = {{"kind", "path"}, {"mechanism", "four_bar"}};
  const bool closed = draw.chance(0.5), timed = draw.chance(0.3);
  const int count =
      draw.chance(0.1) ? draw.whole(3, 9) : static_cast<int>(draw.power_of_ten(0.6, draw.chance(0.1) ? 2.99 : 1.8));
  std::vector<Point> places = drawn_curve(draw, std::max(count, 3), closed);
  spoil(draw, places);
  if (places.size() > 1000) places.resize(1000);
  Json points = Json::array();
  for (const Point place : places) {
    const Json written = written_point(sheet, sheet.shift + sheet.scale * place);
    points.push_back({{"x", written[0]}, {"y", written[1]}});
    if (draw.chance(0.05)) points.back()["weight"] = draw.chance(0.2) ? 0 : draw.power_of_ten(-2, 2);
    if (draw.chance(0.05)) points.back()["tolerance"] = sheet.scale * draw.power_of_ten(-4, 0);
  }
  if (timed) add_timing(draw, closed, points);
  task["points"] = std::move(points);
  if (closed) task["closed"] = true;
  if (draw.chance(0.3)) task["tolerance"] = sheet.scale * draw.power_of_ten(-4, 0);
  if (timed && draw.chance(0.5)) task["timing"] = draw.one_of({"relative", "absolute"});
  if (!timed && draw.chance(0.3)) task["between"] = draw.one_of({"free", "polyline"});
  if (!timed && !task.contains("between")) task["between"] = "free";  // few points, too
  if (timed && !task.contains("timing")) task["timing"] = "relative";
  return task;
}

}  // namespace linkwright::soak
