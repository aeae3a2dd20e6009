#include "straight_line_figure.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/instant/instant_figure.hpp"
#include "drawing/palette.hpp"
#include "drawing/point_marks.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr int places_along_line = 160;

// The line's colour is that of no link, its stretch the accent's.
std::string line_stroke() { return stroke(palette::ink2, 1.2, "14 3 2 3"); }
std::string usable_stroke() { return stroke(palette::accent, 4) + " stroke-linecap=\"round\""; }
std::string path_stroke() { return stroke(palette::accent, 1.4, "0.1 4.5") + " stroke-linecap=\"round\""; }
std::string circle_stroke() { return stroke(palette::link_5, 1.4, "6 4"); }

LineScene scene_along(const TracingFourBar& linkage, const DirectedLine& line, const UsableLine& usable) {
  LineScene scene{.linkage = linkage,
                  .line = line,
                  .whole_path = path_of_cycle(linkage.bars, linkage.point),
                  .usable = {},
                  .ends = {},
                  .instant = analyze_instant(linkage.bars, {.point = linkage.point, .input_acceleration = 0})};
  if (!(usable.length() > 0)) return scene;
  PathLimits limits;
  limits.from = usable.from;
  limits.to = usable.to;
  const auto path = StraightPath::of(linkage, line.direction, limits);
  if (!path) return scene;
  const auto states = path->states(places_along_line);
  for (const auto& state : states) scene.usable.push_back(state.linkage.point);
  scene.ends = {states.front().linkage, states.back().linkage};
  return scene;
}

void draw_tracing_ghost(SvgCanvas& svg, const PlaneWindow& window, const TracingFourBar& linkage) {
  draw_ghost(svg, window, linkage.bars);
  const Point point = window.to_px(linkage.point);
  svg.begin_group("stroke-opacity=\"0.45\"");
  for (const Point pin : {linkage.bars.input_moving, linkage.bars.output_moving})
    svg.line(window.to_px(pin), point, stroke(palette::body, 1.2));
  svg.circle(point, 2.6, fill(palette::accent));
  svg.end_group();
}

void draw_path(SvgCanvas& svg, const PlaneWindow& window, std::span<const Point> path, const std::string& attributes) {
  std::vector<Point> px;
  for (const Point p : path) px.push_back(window.to_px(p));
  for (const auto& piece : window.clipped(px)) svg.polyline(piece, attributes + " stroke-linejoin=\"round\"");
}

std::array<Point, 5> joints_of(const TracingFourBar& linkage) {
  const FourBar& bars = linkage.bars;
  return {bars.input_fixed, bars.input_moving, bars.output_moving, bars.output_fixed, linkage.point};
}

}  // namespace

LineScene line_scene(const StraightLineSolution& found, LineMeasure measure) {
  return scene_along(found.linkage, found.task.line, found.counted(measure));
}

LineScene line_scene(const TracingFourBar& linkage) {
  const auto instant = analyze_instant(linkage.bars, {.point = linkage.point, .input_acceleration = 0});
  const DirectedLine line{linkage.point, instant.point ? instant.point->tangent : Point{}};
  if (line.direction == Point{}) return scene_along(linkage, {linkage.point, {1, 0}}, {});
  const double deviation = LineMeasuring{}.deviation_of(linkage);
  PathLimits limits;
  limits.max_deviation = deviation;
  const auto path = StraightPath::of(linkage, line.direction, limits);
  return scene_along(linkage, line, path ? path->usable(deviation) : UsableLine{});
}

std::vector<Point> points_of_interest(const LineScene& scene) {
  std::vector<Point> points;
  for (const Point joint : joints_of(scene.linkage)) points.push_back(joint);
  for (const TracingFourBar& end : scene.ends)
    for (const Point joint : joints_of(end)) points.push_back(joint);
  Point low = points.front(), high = low;
  for (const Point p : points) {
    low = {std::min(low.real(), p.real()), std::min(low.imag(), p.imag())};
    high = {std::max(high.real(), p.real()), std::max(high.imag(), p.imag())};
  }
  constexpr double not_far = 0.75;  // of the linkage's extent, from its middle
  const Point middle = (low + high) / 2.0;
  const double reach = not_far * std::abs(high - low);
  for (const Point p : scene.whole_path)
    if (std::abs(p - middle) <= reach) points.push_back(p);
  const auto beside = instant_points(scene.instant, middle, reach);
  points.insert(points.end(), beside.begin(), beside.end());
  return points;
}

void draw_wanted_line(SvgCanvas& svg, const PlaneWindow& window, const DirectedLine& line) {
  const Point px = window.to_px(line.point), along = std::conj(line.direction);
  const double far = 2 * (window.box().width + window.box().height) + std::abs(px - window.box().corner());
  if (const auto seen = window.clipped(px - far * along, px + far * along))
    svg.line(seen->first, seen->second, line_stroke());
}

void draw_line_background(SvgCanvas& svg, const PlaneWindow& window, const LineScene& scene) {
  if (scene.instant.instant) draw_inflection_circle(svg, window, *scene.instant.instant, circle_stroke());
  draw_path(svg, window, scene.whole_path, path_stroke() + " stroke-opacity=\"0.6\"");
  for (const TracingFourBar& end : scene.ends) draw_tracing_ghost(svg, window, end);
  draw_body(svg, window, scene.linkage.bars, scene.linkage.point);
  draw_wanted_line(svg, window, scene.line);
  draw_path(svg, window, scene.usable, usable_stroke());
}

void draw_tracing_linkage(SvgCanvas& svg, const PlaneWindow& window, const LineScene& scene) {
  const FourBar& bars = scene.linkage.bars;
  const Point point = scene.linkage.point;
  draw_bars(svg, window, bars);
  draw_pins(svg, window, bars);
  std::vector<Point> taken;
  for (const Point joint : joints_of(scene.linkage)) taken.push_back(window.to_px(joint));
  constexpr Point ground_symbol{0, 14};
  for (const Point center : {bars.input_fixed, bars.output_fixed})
    taken.push_back(window.to_px(center) + ground_symbol);
  // Names keep off the line.
  for (const double px : {-34.0, -17.0, 17.0, 34.0})
    taken.push_back(window.to_px(point) + px * std::conj(scene.line.direction));
  PointMarks marks(svg, window, std::move(taken));
  const auto& ball = scene.instant.ball_point;
  if (ball && std::abs(*ball - point) * window.scale() > 1) marks.add(*ball, "U", palette::link_5);
  if (scene.instant.instant)
    if (const auto pole = pole_of(*scene.instant.instant)) marks.add(*pole, "P", palette::link_5);
  marks.add(point, "C", palette::ink);
  marks.name_only(bars.input_fixed, "A₀", palette::input);
  marks.name_only(bars.input_moving, "A", palette::input);
  marks.name_only(bars.output_fixed, "B₀", palette::output);
  marks.name_only(bars.output_moving, "B", palette::output);
  marks.name();
}

void draw_small_scene(SvgCanvas& svg, const PixelBox& box, const LineScene& scene) {
  const PlaneWindow window(box, points_of_interest(scene), 24);
  svg.begin_clip(box.corner(), box.width, box.height);
  draw_path(svg, window, scene.whole_path, path_stroke() + " stroke-opacity=\"0.6\"");
  draw_body(svg, window, scene.linkage.bars, scene.linkage.point);
  draw_wanted_line(svg, window, scene.line);
  draw_path(svg, window, scene.usable, usable_stroke());
  draw_bars(svg, window, scene.linkage.bars);
  draw_pins(svg, window, scene.linkage.bars);
  svg.circle(window.to_px(scene.linkage.point), 4, fill(palette::ink) + " " + stroke(palette::paper, 1.4));
  svg.end_group();
}

void draw_line_keys(SvgCanvas& svg, Point right) {
  const std::array<std::pair<std::string, std::string_view>, 4> entries = {{{line_stroke(), "line"},
                                                                            {usable_stroke(), "usable length"},
                                                                            {path_stroke(), "path of the point"},
                                                                            {circle_stroke(), "inflection circle"}}};
  double width = 0;
  for (const auto& [attributes, name] : entries) width += line_key_width(name);
  double x = right.real() - width;
  for (const auto& [attributes, name] : entries) x = draw_line_key(svg, {x, right.imag()}, attributes, name);
}

}  // namespace linkwright
