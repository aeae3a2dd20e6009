#include "linkage_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "drawing/palette.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr double link_width = 7, pin_radius = 5.5, disc_radius = 9.5;

/// px of a direction of the fixed frame (y up) in the picture (y down).
Point flipped(Point p) { return std::conj(p); }

void draw_arrow_head(SvgCanvas& svg, Point to, Point along, double head, std::string_view color) {
  const Point across = Point{0, 1} * along;
  const std::array<Point, 3> tip = {to, to - head * along + 0.45 * head * across,
                                    to - head * along - 0.45 * head * across};
  svg.polygon(tip, fill(color));
}

void draw_arrow(SvgCanvas& svg, Point from, Point to, std::string_view color, double width, double head = 6) {
  const Point along = (to - from) / std::abs(to - from);
  svg.line(from, to - 0.6 * head * along, stroke(color, width));
  draw_arrow_head(svg, to, along, head, color);
}

constexpr double direction_width = 2.6, direction_head = 12;

/// Three quarters of a turn round a point, `sense` +1 counter-clockwise.
void draw_turn(SvgCanvas& svg, Point center, double sense) {
  constexpr double radius = 22;
  constexpr int sides = 36;
  std::vector<Point> path;
  for (int i = 0; i <= sides; ++i) path.push_back(center + radius * flipped(direction(sense * 1.5 * pi * i / sides)));
  const Point end = direction(sense * 1.5 * pi), along = flipped(Point{0, sense} * end);
  svg.polyline(path, stroke(palette::accent, direction_width));
  draw_arrow_head(svg, path.back() + direction_head * along, along, direction_head, palette::accent);
}

}  // namespace

void draw_ground_symbol(SvgCanvas& svg, Point pivot) {
  constexpr double half = 10, depth = 17, overhang = 5, hatch = 6;
  const Point left = pivot + Point{-half, depth}, right = pivot + Point{half, depth};
  const std::array<Point, 3> triangle = {pivot, left, right};
  svg.polygon(triangle, fill(palette::paper) + " " + stroke(palette::ink2, 1.4) + " stroke-linejoin=\"round\"");
  svg.line(left - overhang, right + overhang, stroke(palette::ink2, 1.6));
  for (int i = 0; i < 5; ++i) {
    const Point top = left + Point{-overhang + (2 * half + 2 * overhang) * (i + 0.5) / 5 + hatch / 2, 0};
    svg.line(top, top + Point{-hatch, hatch}, stroke(palette::ink2, 1.1));
  }
}

void draw_pin(SvgCanvas& svg, Point pivot, std::string_view color) {
  svg.circle(pivot, pin_radius, fill(palette::paper) + " " + stroke(color, 2.4));
}

void draw_link(SvgCanvas& svg, Point from, Point to, std::string_view color) {
  svg.line(from, to, stroke(color, link_width) + " stroke-linecap=\"round\"");
}

void draw_grid(SvgCanvas& svg, const PlaneWindow& window) {
  constexpr double least_step = 36;  // px
  const PixelBox& box = window.box();
  double step = round_length(least_step / window.scale());
  if (step * window.scale() < least_step) step = round_length(2.5 * step);
  const Point low = window.to_user({box.left, box.bottom()});
  const double step_px = step * window.scale();
  const double first_x = window.to_px({std::ceil(low.real() / step) * step, 0}).real();
  const double first_y = window.to_px({0, std::ceil(low.imag() / step) * step}).imag();
  svg.begin_group(stroke(palette::grid, 1));
  for (int i = 0; first_x + i * step_px <= box.right(); ++i) {
    svg.line({first_x + i * step_px, box.top}, {first_x + i * step_px, box.bottom()}, "");
  }
  for (int i = 0; first_y - i * step_px >= box.top; ++i) {
    svg.line({box.left, first_y - i * step_px}, {box.right(), first_y - i * step_px}, "");
  }
  svg.end_group();
}

void draw_box(SvgCanvas& svg, const PlaneWindow& window, const Box& box, std::string_view name, BoxName place) {
  const Point corner = window.to_px({box.x_low, box.y_high}), opposite = window.to_px({box.x_high, box.y_low});
  const Point size = opposite - corner;
  svg.rectangle(corner, size.real(), size.imag(),
                fill(palette::body, 0.03) + " " + stroke(palette::ink3, 1.2, "1.2 4") + " stroke-linecap=\"round\"");
  const Point visible{std::min(opposite.real(), window.box().right()),
                      std::min(opposite.imag(), window.box().bottom())};
  if (visible.real() - corner.real() < text_width(name, 11) + 16 || visible.imag() - corner.imag() < 20) return;
  const Point above{visible.real(), std::max(corner.imag(), window.box().top) + 22};
  svg.text((place == BoxName::above ? above : visible) + Point{-6, -7}, name,
           {.size = 11, .color = palette::ink3, .anchor = "end", .halo = palette::paper});
}

void draw_traced_path(SvgCanvas& svg, const PlaneWindow& window, std::span<const Point> path, bool is_task) {
  std::vector<Point> px;
  px.reserve(path.size());
  for (const Point p : path) px.push_back(window.to_px(p));
  const std::string attributes =
      (is_task ? stroke(palette::accent, 2, "0.1 4.5") : stroke(palette::accent, 1.4, "0.1 5")) +
      " stroke-linecap=\"round\"" + (is_task ? "" : " stroke-opacity=\"0.6\"");
  for (const auto& piece : window.clipped(px)) svg.polyline(piece, attributes);
}

void draw_ghost(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar) {
  const Point input_fixed = window.to_px(four_bar.input_fixed), input_moving = window.to_px(four_bar.input_moving);
  const Point output_fixed = window.to_px(four_bar.output_fixed), output_moving = window.to_px(four_bar.output_moving);
  svg.begin_group("stroke-opacity=\"0.45\" stroke-linecap=\"round\"");
  svg.line(input_fixed, input_moving, stroke(palette::input, 1.2));
  svg.line(output_fixed, output_moving, stroke(palette::output, 1.2));
  svg.line(input_moving, output_moving, stroke(palette::body, 1.2));
  svg.circle(input_moving, 2.2, fill(palette::input));
  svg.circle(output_moving, 2.2, fill(palette::output));
  svg.end_group();
}

void draw_body(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar, Point frame_origin) {
  const std::array<Point, 3> corners = {window.to_px(four_bar.input_moving), window.to_px(four_bar.output_moving),
                                        window.to_px(frame_origin)};
  svg.polygon(corners, fill(palette::body, 0.1) + " " + stroke(palette::body, 1.2) +
                           " stroke-opacity=\"0.6\" stroke-linejoin=\"round\"");
}

void draw_bars(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar) {
  const Point input_fixed = window.to_px(four_bar.input_fixed), input_moving = window.to_px(four_bar.input_moving);
  const Point output_fixed = window.to_px(four_bar.output_fixed), output_moving = window.to_px(four_bar.output_moving);
  draw_ground_symbol(svg, input_fixed);
  draw_ground_symbol(svg, output_fixed);
  draw_link(svg, input_moving, output_moving, palette::body);
  draw_link(svg, output_fixed, output_moving, palette::output);
  draw_link(svg, input_fixed, input_moving, palette::input);
}

void draw_pins(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar) {
  draw_pin(svg, window.to_px(four_bar.output_fixed), palette::output);
  draw_pin(svg, window.to_px(four_bar.output_moving), palette::output);
  draw_pin(svg, window.to_px(four_bar.input_fixed), palette::input);
  draw_pin(svg, window.to_px(four_bar.input_moving), palette::input);
}

void draw_direction(SvgCanvas& svg, const PlaneWindow& window, const PrescribedPose& pose) {
  constexpr double length = 64, body = 46;  // px: as far from the origin as the frame's arm reaches
  if (pose.derivatives.empty()) return;
  const Point origin = window.to_px(pose.pose.origin);
  const PoseDerivative& way = pose.derivatives.front();
  const double speed = std::abs(way.origin);
  if (speed * window.scale() > 0.1 * std::abs(way.angle) * body) {
    draw_arrow(svg, origin, origin + length * flipped(way.origin / speed), palette::accent, direction_width,
               direction_head);
  } else {
    draw_turn(svg, origin, way.angle < 0 ? -1 : 1);
  }
}

void draw_place(SvgCanvas& svg, const PlaneWindow& window, Point point, std::size_t number, bool strong) {
  const Point at = window.to_px(point);
  svg.circle(at, disc_radius,
             fill(strong ? palette::ink : palette::paper) + " " + stroke(strong ? palette::ink : palette::ink2, 1.5));
  svg.text(at + Point{0, 4}, fmt::format("{}", number),
           {.size = 12, .color = strong ? palette::paper : palette::ink, .anchor = "middle", .weight = 650});
}

void draw_pose(SvgCanvas& svg, const PlaneWindow& window, const Pose& pose, std::size_t number, bool strong) {
  constexpr double x_arm = 46, y_arm = 30;
  const Point origin = window.to_px(pose.origin);
  const std::string_view color = strong ? palette::ink : palette::ink2;
  const double width = strong ? 1.8 : 1.3;
  draw_arrow(svg, origin, origin + x_arm * flipped(direction(pose.angle)), color, width);
  draw_arrow(svg, origin, origin + y_arm * flipped(direction(pose.angle + pi / 2)), color, width);
  draw_place(svg, window, pose.origin, number, strong);
}

void draw_scale_bar(SvgCanvas& svg, const PlaneWindow& window, Point left, std::string_view unit) {
  constexpr double longest = 150, tick = 4;
  const double length = round_length(longest / window.scale());
  const Point right = left + length * window.scale();
  svg.begin_group(stroke(palette::ink2, 1.4));
  svg.line(left, right, "");
  svg.line(left - Point{0, tick}, left + Point{0, tick}, "");
  svg.line(right - Point{0, tick}, right + Point{0, tick}, "");
  svg.end_group();
  const std::string text = fmt::format("{} {}", significant_text(length, 1), unit);
  svg.text((left + right) / 2.0 + Point{0, -7}, text,
           {.size = 12, .color = palette::ink2, .anchor = "middle", .halo = palette::paper});
}

namespace {

constexpr double key_sample = 30, key_gap = 7, key_size = 12, key_space = 18;

}  // namespace

double line_key_width(std::string_view name) { return key_sample + key_gap + text_width(name, key_size) + key_space; }

double draw_line_key(SvgCanvas& svg, Point left, std::string_view attributes, std::string_view name) {
  svg.line(left, left + key_sample, attributes);
  svg.text(left + Point{key_sample + key_gap, 4}, name, {.size = key_size, .color = palette::ink2});
  return left.real() + line_key_width(name);
}

}  // namespace linkwright
