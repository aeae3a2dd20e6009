#include "linkwright/files/outline_file.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "files/text/plain_text.hpp"
#include "linkwright/files/length_unit.hpp"
#include "shapes.hpp"
#include "strokes.hpp"

namespace linkwright {
namespace {

Result<Drawing> drawing_of(Result<Strokes> strokes) {
  if (!strokes) return strokes.errors();
  const std::optional<double> unit = strokes->unit_mm;
  std::vector<DrawnShape> shapes = shapes_of(*std::move(strokes));
  if (shapes.empty())
    return Error{
        "no_outline", "",
        "this has no shape with three or more corners; the outline can be a closed line or a chain of lines and "
        "arcs in an SVG or DXF file"};
  return Drawing{std::move(shapes), unit};
}

double at_nine_digits(double value) {
  return leading_number(fmt::format("{:.9g}", value)) + 0.0;  // never -0
}

}  // namespace

Result<Drawing> read_dxf_outlines(std::string_view text) { return drawing_of(dxf_strokes(text)); }
Result<Drawing> read_svg_outlines(const XmlElements& elements) { return drawing_of(svg_strokes(elements)); }

double drawing_scale(std::optional<double> unit_mm, std::string_view length_unit) {
  const auto length_mm = millimetres(length_unit);
  return unit_mm && length_mm ? *unit_mm / *length_mm : 1;
}

Drawing drawing_of_points(std::vector<Point> points) {
  DrawnShape shape;
  shape.closed = points.size() > 3 && points.front() == points.back();
  if (shape.closed) points.pop_back();
  const auto by_x = [](Point a, Point b) { return a.real() < b.real(); };
  const auto by_y = [](Point a, Point b) { return a.imag() < b.imag(); };
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_x);
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), by_y);
  shape.width = right->real() - left->real();
  shape.height = highest->imag() - lowest->imag();
  shape.corners = std::move(points);
  return {{std::move(shape)}, std::nullopt, true};
}

std::vector<Point> points_along(const DrawnShape& shape, int count) {
  std::vector<Point> corners = shape.corners;
  if (shape.closed) corners.push_back(corners.front());
  std::vector<double> reached = {0};
  for (std::size_t i = 1; i < corners.size(); ++i)
    reached.push_back(reached.back() + std::abs(corners[i] - corners[i - 1]));
  std::vector<Point> points;
  std::size_t side = 1;
  for (int k = 0; k < count; ++k) {
    const double way = reached.back() * k / (shape.closed ? count : count - 1);
    while (side + 1 < corners.size() && reached[side] < way) ++side;
    const double length = reached[side] - reached[side - 1];
    const double share = length > 0 ? (way - reached[side - 1]) / length : 0;
    points.push_back(corners[side - 1] + share * (corners[side] - corners[side - 1]));
  }
  return points;
}

std::vector<Point> body_outline(const DrawnShape& shape, double scale, const Pose& placed) {
  std::vector<Point> outline;
  for (const Point corner : simplified(shape.corners)) {
    const Point at = placed.origin + direction(placed.angle) * (scale * corner);
    outline.emplace_back(at_nine_digits(at.real()), at_nine_digits(at.imag()));
  }
  return outline;
}

OutlineFit fit_outline(const DrawnShape& shape, double scale, double size) {
  constexpr double another_size = 20;
  double left = shape.corners[0].real(), bottom = shape.corners[0].imag();
  for (const Point corner : shape.corners) {
    left = std::min(left, corner.real());
    bottom = std::min(bottom, corner.imag());
  }
  OutlineFit fit{scale, {}};
  const double w = shape.width, h = shape.height, largest = scale * std::max(w, h);
  fit.resized = largest > another_size * size || largest < size / another_size;
  if (fit.resized) fit.scale = scale * size / largest;
  const bool is_near = left - w / 2 <= 0 && left + 1.5 * w >= 0 && bottom - h / 2 <= 0 && bottom + 1.5 * h >= 0;
  if (!is_near) fit.placed.origin = -fit.scale * Point{left + w / 2, bottom + h / 2};
  return fit;
}

}  // namespace linkwright
