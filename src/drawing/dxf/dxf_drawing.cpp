#include "drawing/dxf_drawing.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "drawing/four_bar/linkage_figure.hpp"
#include "dxf_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "loads/carried.hpp"

namespace linkwright {
namespace {

constexpr std::string_view ground = "GROUND", input = "INPUT", coupler = "COUPLER", output = "OUTPUT",
                           coupler_curve = "COUPLER_CURVE", springs_layer = "SPRINGS", cylinder_layer = "CYLINDER",
                           masses_layer = "MASSES", handle_layer = "HANDLE";

/// Radius of the pin holes: small against the shortest link, visible against the longest.
double drawn_pin_radius(const LinkLengths& lengths) {
  return std::min(0.1 * lengths.shortest(), 0.015 * lengths.longest());
}

void draw_ground(DxfWriter& dxf, const FourBar& bars, double radius) {
  for (const Point pivot : {bars.input_fixed, bars.output_fixed}) draw_ground_pivot(dxf, ground, pivot, radius);
  dxf.line(ground, bars.input_fixed, bars.output_fixed);
}

/// The coupler; with a point, the triangle that carries it.
void draw_coupler(DxfWriter& dxf, const StoredLinkage& linkage, double radius) {
  const FourBar& bars = linkage.four_bar;
  draw_link(dxf, coupler, bars.input_moving, bars.output_moving, radius);
  if (!linkage.point) return;
  const std::array<Point, 3> corners = {bars.input_moving, bars.output_moving, *linkage.point};
  dxf.polyline(coupler, corners, true);
  dxf.circle(coupler, *linkage.point, radius);
}

void draw_positions(DxfWriter& dxf, const StoredLinkage& linkage, double frame_size) {
  const std::vector<FourBar> as_it_moves = in_positions(linkage);
  for (std::size_t pose = 0; pose < linkage.poses.size(); ++pose) {
    draw_frame(dxf, positions_layer, linkage.poses[pose].pose, pose + 1, frame_size);
    if (pose == 0) continue;
    const FourBar& bars = as_it_moves[pose];
    const std::array<Point, 4> links = {bars.input_fixed, bars.input_moving, bars.output_moving, bars.output_fixed};
    dxf.polyline(positions_layer, links, false);
  }
}

void draw_coupler_curve(DxfWriter& dxf, const StoredLinkage& linkage) {
  std::vector<Point> path = path_of_cycle(linkage.four_bar, traced_point(linkage));
  if (path.size() > 2) path.pop_back();  // the first point again
  dxf.polyline(coupler_curve, path, true);
}

/// Both studs, and the line between them.
void draw_strut(DxfWriter& dxf, std::string_view layer, const LoadMarks::Strut& strut, double radius) {
  dxf.circle(layer, strut.from, radius);
  dxf.circle(layer, strut.to, radius);
  dxf.line(layer, strut.from, strut.to);
}

/// A circle with a cross.
void draw_mark(DxfWriter& dxf, std::string_view layer, Point at, double radius) {
  dxf.circle(layer, at, radius);
  for (const Point arm : {Point{1.5 * radius, 0}, Point{0, 1.5 * radius}}) dxf.line(layer, at - arm, at + arm);
}

void draw_loads(DxfWriter& dxf, const LoadMarks& marks, double radius) {
  for (const LoadMarks::Strut& spring : marks.springs) draw_strut(dxf, springs_layer, spring, radius);
  if (marks.cylinder) draw_strut(dxf, cylinder_layer, *marks.cylinder, radius);
  for (const Point mass : marks.masses) draw_mark(dxf, masses_layer, mass, radius);
  if (marks.handle) draw_mark(dxf, handle_layer, *marks.handle, radius);
}

}  // namespace

std::string draw_dxf(const StoredLinkage& linkage, const Loads* loads) {
  std::vector<DxfLayer> layers = {{ground, 8},  {input, 5},           {coupler, 7},
                                  {output, 30}, {positions_layer, 9}, {coupler_curve, 3}};
  if (loads) layers.insert(layers.end(), {{springs_layer, 1}, {masses_layer, 6}, {handle_layer, 4}});
  if (loads && loads->drive == LoadDrive::cylinder) layers.push_back({cylinder_layer, 2});
  DxfWriter dxf(insert_units(linkage.length_unit), layers);
  const FourBar& bars = linkage.four_bar;
  const LinkLengths lengths = bars.lengths();
  const double radius = drawn_pin_radius(lengths);
  draw_ground(dxf, bars, radius);
  draw_link(dxf, input, bars.input_fixed, bars.input_moving, radius);
  draw_coupler(dxf, linkage, radius);
  draw_link(dxf, output, bars.output_fixed, bars.output_moving, radius);
  draw_positions(dxf, linkage, 0.12 * lengths.longest());
  draw_coupler_curve(dxf, linkage);
  if (loads) draw_loads(dxf, marks_of(*loads, bars, linkage.poses.front().pose), radius);
  return dxf.file();
}

}  // namespace linkwright
