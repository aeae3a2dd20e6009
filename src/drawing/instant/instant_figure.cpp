#include "instant_figure.hpp"

#include <array>
#include <string>

#include "drawing/curve_path.hpp"
#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/palette.hpp"
#include "drawing/point_marks.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/infinitesimal/stationary_curvature.hpp"

namespace linkwright {
namespace {

using Curve = std::function<Homogeneous(double share)>;

Curve curve_of(const Circle& circle) {
  return [circle](double share) { return Homogeneous::of(circle.center + circle.radius * direction(two_pi * share)); };
}
Curve curve_of(const StraightLine& line) {
  return [line](double share) {
    const double c = std::cos(pi * share), s = std::sin(pi * share);
    const Point p = c * line.point + s * line.direction;
    return Homogeneous{c, p.real(), p.imag()};
  };
}
Curve curve_of(const CircleOrLine& circle) {
  return std::visit([](const auto& shape) { return curve_of(shape); }, circle);
}

// The lines of the figure.
std::string inflection_stroke() { return stroke(palette::accent, 2); }
std::string return_stroke() { return stroke(palette::accent, 1.6, "2 3"); }
std::string bresse_stroke() { return stroke(palette::good, 1.6, "8 5"); }
std::string circling_stroke() { return stroke(palette::link_5, 2); }
std::string centering_stroke() { return stroke(palette::link_5, 1.6, "5 4"); }
std::string axis_stroke() { return stroke(palette::ink3, 1, "12 3 2 3"); }

void draw_curve(SvgCanvas& svg, const PlaneWindow& window, const Curve& curve, const std::string& attributes) {
  for (const auto& path : visible_curve(curve, window)) svg.polyline(path, attributes + " stroke-linejoin=\"round\"");
}

void draw_stationary_curve(SvgCanvas& svg, const PlaneWindow& window, const StationaryCurve& curve,
                           const std::string& attributes) {
  for (const auto& piece : curve.pieces) draw_curve(svg, window, piece, attributes);
}

// Its name stands where the line leaves the window, on the side that has room.
void draw_axis(SvgCanvas& svg, const PlaneWindow& window, const StraightLine& line, std::string_view name) {
  const auto seen = visible_curve(curve_of(line), window);
  for (const auto& path : seen) svg.polyline(path, axis_stroke());
  if (seen.empty()) return;
  const PixelBox& box = window.box();
  const double half = text_width(name, 12) / 2 + 10;
  const Point px = window.to_px(line.point), along = std::conj(line.direction);
  // The largest way along the line that leaves the name inside.
  double way = 1e9;
  const auto limit = [&](double from, double step, double low, double high) {
    if (step > 1e-9) way = std::min(way, (high - from) / step);
    if (step < -1e-9) way = std::min(way, (low - from) / step);
  };
  limit(px.real(), along.real(), box.left + half, box.right() - half);
  limit(px.imag(), along.imag(), box.top + 16, box.bottom() - 20);
  if (!(way > 40)) return;
  svg.text(px + way * along + Point{0, 4}, name,
           {.size = 12, .color = palette::ink3, .anchor = "middle", .halo = palette::paper});
}

void draw_frame(SvgCanvas& svg, const PlaneWindow& window, const Instant& instant) {
  if (const auto* turning = std::get_if<TurningInstant>(&instant)) {
    draw_axis(svg, window, {turning->pole, turning->tangent}, "pole tangent");
    draw_axis(svg, window, {turning->pole, turning->tangent * Point{0, 1}}, "pole normal");
  }
}

void draw_path_now(SvgCanvas& svg, const PlaneWindow& window, const PathNow& path, PointMarks& marks) {
  const auto center = path.center ? finite_point(*path.center) : std::nullopt;
  if (center) {
    const auto seen = window.clipped(window.to_px(path.point), window.to_px(*center));
    if (seen) svg.line(seen->first, seen->second, stroke(palette::ink2, 1.4));
    marks.add(*center, "C₀", palette::ink2);
  }
  marks.add(path.point, "C", palette::ink);
}

}  // namespace

void draw_instant_curves(SvgCanvas& svg, const PlaneWindow& window, const InstantAnalysis& analysis) {
  if (!analysis.instant) return;
  const Instant& instant = *analysis.instant;
  draw_frame(svg, window, instant);
  if (analysis.bresse_circle) draw_curve(svg, window, curve_of(*analysis.bresse_circle), bresse_stroke());
  draw_stationary_curve(svg, window, centering_point_curve(instant), centering_stroke());
  draw_stationary_curve(svg, window, circling_point_curve(instant), circling_stroke());
  if (const auto* turning = std::get_if<TurningInstant>(&instant))
    draw_curve(svg, window, curve_of(turning->return_circle()), return_stroke());
  draw_inflection_circle(svg, window, instant, inflection_stroke());
}

void draw_inflection_circle(SvgCanvas& svg, const PlaneWindow& window, const Instant& instant,
                            const std::string& attributes) {
  if (const auto circle = inflection_circle(instant)) draw_curve(svg, window, curve_of(*circle), attributes);
}

void draw_instant_points(SvgCanvas& svg, const PlaneWindow& window, const InstantAnalysis& analysis,
                         std::vector<Point> taken) {
  if (!analysis.instant) return;
  PointMarks marks(svg, window, std::move(taken));
  if (analysis.point) draw_path_now(svg, window, *analysis.point, marks);
  for (const CurvaturePair& pair : analysis.burmester_points)
    if (const auto moving = finite_point(pair.moving)) marks.square(*moving, palette::link_5);
  if (analysis.acceleration_pole) marks.add(*analysis.acceleration_pole, "J", palette::good);
  if (const auto* turning = std::get_if<TurningInstant>(&*analysis.instant))
    marks.add(turning->inflection_pole(), "W", palette::accent);
  if (analysis.ball_point) marks.add(*analysis.ball_point, "U", palette::link_5);
  if (const auto pole = pole_of(*analysis.instant)) marks.add(*pole, "P", palette::ink);
  marks.name();
}

void draw_instant_key(SvgCanvas& svg, Point left, const InstantAnalysis& analysis) {
  if (!analysis.instant) return;
  const bool is_turning = std::holds_alternative<TurningInstant>(*analysis.instant);
  const auto entry = [&](const std::string& attributes, std::string_view name) {
    left = {draw_line_key(svg, left, attributes, name), left.imag()};
  };
  entry(inflection_stroke(), is_turning ? "inflection circle" : "inflection line");
  if (is_turning) entry(return_stroke(), "return circle");
  if (analysis.bresse_circle)
    entry(bresse_stroke(), std::holds_alternative<Circle>(*analysis.bresse_circle) ? "Bresse circle" : "Bresse line");
  entry(circling_stroke(), "circling points");
  entry(centering_stroke(), "centering points");
  if (analysis.burmester_points.empty()) return;
  draw_square_mark(svg, left + 8.0, palette::link_5);
  svg.text(left + Point{20, 4}, "Burmester points", {.size = 12, .color = palette::ink2});
}

std::vector<Point> instant_points(const InstantAnalysis& analysis, Point center, double reach) {
  std::vector<Point> points;
  const auto add = [&](const std::optional<Point>& point) {
    if (point && std::abs(*point - center) <= reach) points.push_back(*point);
  };
  if (!analysis.instant) return points;
  add(pole_of(*analysis.instant));
  add(analysis.ball_point);
  add(analysis.acceleration_pole);
  if (analysis.point) {
    add(analysis.point->point);
    if (analysis.point->center) add(finite_point(*analysis.point->center));
  }
  if (const auto* turning = std::get_if<TurningInstant>(&*analysis.instant)) {
    const Circle circle = turning->inflection_circle();
    for (int i = 0; i < 8; ++i) add(circle.center + circle.radius * direction(two_pi * i / 8));
  }
  return points;
}

}  // namespace linkwright
