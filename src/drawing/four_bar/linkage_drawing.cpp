#include "drawing/number_rows.hpp"
#include "drawing/palette.hpp"
#include "drawing/sheet.hpp"
#include "drawing/straight_line/straight_line_figure.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkage_figure.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "loads/carried.hpp"

namespace linkwright {
namespace {

constexpr PixelBox card{linkage_sheet::border, 64, linkage_sheet::width - 2 * linkage_sheet::border, 592};
constexpr PixelBox strip{linkage_sheet::border, 672, linkage_sheet::width - 2 * linkage_sheet::border, 108};

std::vector<Point> points_of_interest(const StoredLinkage& linkage) {
  const FourBar& bars = linkage.four_bar;
  std::vector<Point> points = {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving};
  for (const FourBar& there : in_positions(linkage))
    points.insert(points.end(), {there.input_moving, there.output_moving});
  for (const PrescribedPose& pose : linkage.poses) points.push_back(pose.pose.origin);
  if (linkage.poses.empty()) {
    for (const Point p : path_of_cycle(bars, traced_point(linkage))) points.push_back(p);
  }
  return points;
}

void draw_ground_line(SvgCanvas& svg, const PlaneWindow& window, const FourBar& bars) {
  svg.line(window.to_px(bars.input_fixed), window.to_px(bars.output_fixed), stroke(palette::ink3, 1, "9 3 2 3"));
}

void draw_positions(SvgCanvas& svg, const PlaneWindow& window, const StoredLinkage& linkage) {
  const Point traced = traced_point(linkage);
  draw_traced_path(svg, window, path_of_cycle(linkage.four_bar, traced), linkage.poses.empty());
  const std::vector<FourBar> positions = in_positions(linkage);
  for (std::size_t pose = positions.size(); pose-- > 1;) draw_ghost(svg, window, positions[pose]);
  if (linkage.poses.empty()) return;
  draw_traced_path(svg, window, path_of_task(linkage.four_bar, linkage.poses, traced), true);
  draw_body(svg, window, linkage.four_bar, traced);
}

void draw_strut(SvgCanvas& svg, const PlaneWindow& window, const LoadMarks::Strut& strut, std::string_view color) {
  const Point from = window.to_px(strut.from), to = window.to_px(strut.to);
  svg.line(from, to, stroke(color, 3));
  for (const Point stud : {from, to}) svg.circle(stud, 4, fill(palette::paper) + " " + stroke(color, 1.6));
}

/// A centre of mass.
void draw_mass(SvgCanvas& svg, Point at) {
  constexpr double radius = 6;
  svg.circle(at, radius, fill(palette::paper) + " " + stroke(palette::ink2, 1.4));
  for (const Point arm : {Point{radius, 0}, Point{0, radius}}) svg.line(at - arm, at + arm, stroke(palette::ink2, 1.4));
}

void draw_loads(SvgCanvas& svg, const PlaneWindow& window, const LoadMarks& marks) {
  for (const LoadMarks::Strut& spring : marks.springs) draw_strut(svg, window, spring, palette::link_2);
  if (marks.cylinder) draw_strut(svg, window, *marks.cylinder, palette::link_5);
  for (const Point mass : marks.masses) draw_mass(svg, window.to_px(mass));
  if (marks.handle) svg.circle(window.to_px(*marks.handle), 6, fill("none") + " " + stroke(palette::accent, 2.4));
}

void draw_scene(SvgCanvas& svg, const StoredLinkage& linkage, const LoadMarks& marks) {
  const FourBar& bars = linkage.four_bar;
  const PixelBox inside{card.left + 1, card.top + 1, card.width - 2, card.height - 2};
  std::vector<Point> points = points_of_interest(linkage);
  const std::vector<Point> loaded = marks.points();
  points.insert(points.end(), loaded.begin(), loaded.end());
  const PlaneWindow window(inside, points, 76);
  svg.begin_clip(inside.corner(), inside.width, inside.height);
  draw_grid(svg, window);
  draw_ground_line(svg, window, bars);
  draw_positions(svg, window, linkage);
  draw_bars(svg, window, bars);
  for (std::size_t pose = linkage.poses.size(); pose-- > 0;) {
    draw_direction(svg, window, linkage.poses[pose]);
    draw_pose(svg, window, linkage.poses[pose].pose, pose + 1, pose == 0);
  }
  draw_pins(svg, window, bars);
  draw_loads(svg, window, marks);
  draw_dimensions(svg, window, bars);
  draw_scale_bar(svg, window, {card.left + 24, card.bottom() - 22}, linkage.length_unit);
  svg.end_group();
}

/// With the path of its point, and the line along which that runs.
void draw_scene(SvgCanvas& svg, const TracingFourBar& linkage, std::string_view unit) {
  constexpr double key_height = 34;
  const PixelBox inside{card.left + 1, card.top + key_height, card.width - 2, card.height - key_height - 1};
  const LineScene scene = line_scene(linkage);
  const PlaneWindow window(inside, points_of_interest(scene), 64);
  svg.begin_clip(inside.corner(), inside.width, inside.height);
  draw_grid(svg, window);
  draw_ground_line(svg, window, linkage.bars);
  draw_line_background(svg, window, scene);
  draw_tracing_linkage(svg, window, scene);
  draw_dimensions(svg, window, linkage.bars);
  draw_scale_bar(svg, window, {card.left + 24, card.bottom() - 22}, unit);
  svg.end_group();
  draw_line_keys(svg, {card.right(), card.top + key_height / 2});
}

void draw_arm_rows(SvgCanvas& svg, Point corner, const TracingFourBar& linkage) {
  const int decimals = length_decimals(linkage.longest());
  const auto text = [&](double value) { return rounded_text(value, decimals); };
  NumberRows rows(svg, corner, 210);
  rows.row("point C", text(linkage.point.real()) + ", " + text(linkage.point.imag()));
  rows.row("C to input pin", text(std::abs(linkage.point - linkage.bars.input_moving)), palette::input);
  rows.row("C to output pin", text(std::abs(linkage.point - linkage.bars.output_moving)), palette::output);
}

}  // namespace

std::string draw_linkage(const StoredLinkage& linkage, const Loads* loads) {
  const FourBar& bars = linkage.four_bar;
  const LoadMarks marks = loads ? marks_of(*loads, bars, linkage.poses.front().pose) : LoadMarks{};
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Four-bar linkage" : linkage.title,
                                       label(linkage_type(bars.lengths())));
  draw_card(svg, card, "");
  linkage.point ? draw_scene(svg, {bars, *linkage.point}, linkage.length_unit) : draw_scene(svg, linkage, marks);
  draw_card(svg, strip, "");
  const double rows_width = linkage.point ? 170 : 260, pivots_left = linkage.point ? 226 : 400,
               pivots_width = linkage.point ? 440 : 540;
  draw_length_rows(svg, strip.corner() + Point{18, -9}, rows_width, bars.lengths(), linkage.length_unit);
  draw_pivot_rows(svg, strip.corner() + Point{pivots_left, -9}, pivots_width, bars);
  if (linkage.point) draw_arm_rows(svg, strip.corner() + Point{714, -9}, {bars, *linkage.point});
  return svg.file();
}

}  // namespace linkwright
