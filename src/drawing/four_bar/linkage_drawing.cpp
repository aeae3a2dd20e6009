#include "dimension_figure.hpp"
#include "drawing/palette.hpp"
#include "drawing/sheet.hpp"
#include "drawing/svg_canvas.hpp"
#include "linkage_figure.hpp"
#include "linkage_positions.hpp"
#include "linkage_strip.hpp"
#include "linkwright/analysis/linkage_type.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/label.hpp"

namespace linkwright {
namespace {

constexpr PixelBox card{linkage_sheet::border, 64, linkage_sheet::width - 2 * linkage_sheet::border, 592};
constexpr PixelBox strip{linkage_sheet::border, 672, linkage_sheet::width - 2 * linkage_sheet::border, 108};

std::vector<Point> points_of_interest(const StoredLinkage& linkage) {
  const FourBar& bars = linkage.four_bar;
  std::vector<Point> points = {bars.input_center, bars.input_circle, bars.output_center, bars.output_circle};
  for (std::size_t pose = 0; pose < linkage.poses.size(); ++pose) {
    const FourBar there = in_pose(bars, linkage.poses, pose);
    points.insert(points.end(), {there.input_circle, there.output_circle, linkage.poses[pose].pose.origin});
  }
  if (linkage.poses.empty()) {
    for (const Point p : path_of_cycle(bars, traced_point(linkage))) points.push_back(p);
  }
  return points;
}

void draw_ground_line(SvgCanvas& svg, const PlaneWindow& window, const FourBar& bars) {
  svg.line(window.to_px(bars.input_center), window.to_px(bars.output_center), stroke(palette::ink3, 1, "9 3 2 3"));
}

void draw_positions(SvgCanvas& svg, const PlaneWindow& window, const StoredLinkage& linkage) {
  const Point traced = traced_point(linkage);
  draw_traced_path(svg, window, path_of_cycle(linkage.four_bar, traced), linkage.poses.empty());
  for (std::size_t pose = linkage.poses.size(); pose-- > 1;) {
    draw_ghost(svg, window, in_pose(linkage.four_bar, linkage.poses, pose));
  }
  if (linkage.poses.empty()) return;
  draw_traced_path(svg, window, path_of_task(linkage.four_bar, linkage.poses, traced), true);
  draw_body(svg, window, linkage.four_bar, traced);
}

void draw_scene(SvgCanvas& svg, const StoredLinkage& linkage) {
  const FourBar& bars = linkage.four_bar;
  const PixelBox inside{card.left + 1, card.top + 1, card.width - 2, card.height - 2};
  const PlaneWindow window(inside, points_of_interest(linkage), 76);
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
  draw_dimensions(svg, window, bars);
  draw_scale_bar(svg, window, {card.left + 24, card.bottom() - 22}, linkage.length_unit);
  svg.end_group();
}

}  // namespace

std::string draw_linkage(const StoredLinkage& linkage) {
  const FourBar& bars = linkage.four_bar;
  SvgCanvas svg = linkage_sheet::begin(linkage.title.empty() ? "Four-bar linkage" : linkage.title,
                                       label(linkage_type(bars.lengths())));
  draw_card(svg, card, "");
  draw_scene(svg, linkage);
  draw_card(svg, strip, "");
  draw_length_rows(svg, strip.corner() + Point{18, -9}, 260, bars.lengths(), linkage.length_unit);
  draw_pivot_rows(svg, strip.corner() + Point{400, -9}, 540, bars);
  return svg.file();
}

}  // namespace linkwright
