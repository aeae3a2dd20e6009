#include <algorithm>

#include "drawing/dxf/dxf_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "print_file.hpp"

namespace linkwright {
namespace {

constexpr int millimetre_units = 4;  // $INSUNITS
constexpr int colors[] = {8, 5, 7, 30, 6, 4};

/// The plate moved to where it is drawn, millimetres.
struct Blank {
  std::vector<Point> outline, holes;
  double radius = 0, hole_radius = 0;
};

Blank blank_of(const FlatPlate& plate, double scale) {
  const Point along = plate.outline[1] - plate.outline[0], turn = scale * std::conj(along) / std::abs(along);
  Blank blank{{}, {}, scale * plate.radius, scale * plate.hole_radius};
  for (const Point corner : plate.outline) blank.outline.push_back(turn * corner);
  for (const Point hole : plate.holes) blank.holes.push_back(turn * hole);
  return blank;
}

void draw_outline(DxfWriter& dxf, std::string_view layer, const Blank& blank) {
  const std::size_t count = blank.outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point before = blank.outline[(i + count - 1) % count], here = blank.outline[i],
                after = blank.outline[(i + 1) % count];
    const double from = std::arg(here - before) - pi / 2, to = std::arg(after - here) - pi / 2;
    dxf.arc(layer, here, blank.radius, from, to < from ? to + two_pi : to);
    const Point aside = blank.radius * direction(to);
    dxf.line(layer, here + aside, after + aside);
  }
}

}  // namespace

std::string draw_plates(const Machine& machine) {
  if (machine.linkage.spherical) return "";
  const double scale = machine.linkage.millimetres(), gap = scale * machine.sizes.pin;
  std::vector<DxfLayer> layers;
  for (std::size_t body = 0; body < machine.linkage.bodies.size(); ++body)
    layers.push_back({machine.linkage.bodies[body], colors[body % std::size(colors)]});
  DxfWriter dxf(millimetre_units, layers);
  double y = 0;
  for (std::size_t body = 0; body < layers.size(); ++body) {
    Blank blank = blank_of(std::get<FlatPlate>(machine.parts[body].shape), scale);
    double left = 1e300, low = 1e300, high = -1e300;
    for (const Point corner : blank.outline) {
      left = std::min(left, corner.real());
      low = std::min(low, corner.imag());
      high = std::max(high, corner.imag());
    }
    const Point shift{blank.radius - left, y + blank.radius - low};
    for (Point& corner : blank.outline) corner += shift;
    for (Point& hole : blank.holes) hole += shift;
    draw_outline(dxf, layers[body].name, blank);
    for (const Point hole : blank.holes) dxf.circle(layers[body].name, hole, blank.hole_radius);
    y += high - low + 2 * blank.radius + gap;
  }
  return dxf.file();
}

}  // namespace linkwright
