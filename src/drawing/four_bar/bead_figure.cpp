#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>

#include "drawing/palette.hpp"
#include "linkage_figure.hpp"

namespace linkwright {
namespace {

constexpr double radius = 4.5, name_size = 12, bead_key_gap = 6, bead_key_space = 16;
constexpr std::array<std::string_view, 2> key_names = {"fixed pivot", "moving pivot"};

void draw_open(SvgCanvas& svg, Point at) {
  svg.circle(at, radius, fill(palette::paper) + " " + stroke(palette::ink2, 1.8));
}
void draw_full(SvgCanvas& svg, Point at) { svg.circle(at, radius, fill(palette::ink2)); }

std::optional<Point> pivot_of(Homogeneous point, const WorkingFrame& frame) {
  if (is_at_infinity(frame.to_working(point))) return std::nullopt;
  return point.vector() / point.w;
}

struct Bead {
  Point at;  ///< px
  bool is_center = false;
  std::size_t number = 0;
};

/// Far pivots of long grounded links lie outside of the picture.
bool is_seen(Point px, const PixelBox& box) {
  constexpr double room = 3 * radius;  // for the bead and its number
  return px.real() > box.left + room && px.real() < box.right() - room && px.imag() > box.top + room &&
         px.imag() < box.bottom() - room;
}

/// The place round a bead that is farthest from what is there already; the first of those that are far enough.
Point free_place(Point bead, const std::vector<Point>& taken) {
  constexpr double far_enough = 13;
  constexpr std::array<Point, 4> ways = {Point{10, -10}, Point{-10, -10}, Point{10, 11}, Point{-10, 11}};
  Point best = bead + ways[0];
  double most = -1;
  for (const Point way : ways) {
    double room = far_enough;
    for (const Point other : taken)
      if (std::abs(other - bead) > 0) room = std::min(room, std::abs(other - (bead + way)));
    if (room > most) {
      most = room;
      best = bead + way;
    }
  }
  return best;
}

}  // namespace

std::vector<Point> finite_pivots(const Dyad& dyad, const WorkingFrame& frame) {
  std::vector<Point> pivots;
  for (const Homogeneous point : {dyad.center, dyad.circle})
    if (const auto pivot = pivot_of(point, frame)) pivots.push_back(*pivot);
  return pivots;
}

void draw_bead_links(SvgCanvas& svg, const PlaneWindow& window, const WorkingFrame& frame,
                     std::span<const Dyad> dyads) {
  for (const Dyad& dyad : dyads) {
    const auto center = pivot_of(dyad.center, frame), circle = pivot_of(dyad.circle, frame);
    if (!center || !circle) continue;
    const auto seen = window.clipped(window.to_px(*center), window.to_px(*circle));
    if (seen) svg.line(seen->first, seen->second, stroke(palette::curve, 1.2, "3 3"));
  }
}

void draw_beads(SvgCanvas& svg, const PlaneWindow& window, const WorkingFrame& frame, std::span<const Dyad> dyads,
                std::vector<Point> taken) {
  std::vector<Bead> beads;
  const auto add = [&](std::optional<Point> pivot, bool is_center, std::size_t number) {
    if (pivot && is_seen(window.to_px(*pivot), window.box()))
      beads.push_back({window.to_px(*pivot), is_center, number});
  };
  for (std::size_t i = 0; i < dyads.size(); ++i) {
    add(pivot_of(dyads[i].center, frame), true, i + 1);
    add(pivot_of(dyads[i].circle, frame), false, i + 1);
  }
  for (const Bead& bead : beads) {
    bead.is_center ? draw_open(svg, bead.at) : draw_full(svg, bead.at);
    taken.push_back(bead.at);
  }
  for (const Bead& bead : beads) {
    const Point middle = free_place(bead.at, taken);
    taken.push_back(middle);
    svg.text(middle + Point{0, 4}, fmt::format("{}", bead.number),
             {.size = name_size, .color = palette::ink2, .anchor = "middle", .weight = 650, .halo = palette::paper});
  }
}

double bead_key_width() {
  double width = 0;
  for (const std::string_view name : key_names)
    width += 2 * radius + bead_key_gap + text_width(name, name_size) + bead_key_space;
  return width;
}

double draw_bead_key(SvgCanvas& svg, Point left) {
  Point at = left;
  for (const std::string_view name : key_names) {
    name == key_names.front() ? draw_open(svg, at + radius) : draw_full(svg, at + radius);
    svg.text(at + Point{2 * radius + bead_key_gap, 4}, name, {.size = name_size, .color = palette::ink2});
    at += 2 * radius + bead_key_gap + text_width(name, name_size) + bead_key_space;
  }
  return at.real();
}

}  // namespace linkwright
