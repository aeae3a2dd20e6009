#include "spherical_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "drawing/four_bar/linkage_figure.hpp"
#include "drawing/palette.hpp"
#include "drawing/point_marks.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double link_width = 7, small_radius = 150;  // below it, px, a view leaves the small things out
constexpr Vector3 usual_view{0.74, 0.53, 0.41};       // where no axes say from where to look

/// The same on a side of the sphere: the one that is seen, or thin and pale behind it.
void draw_paths(SvgCanvas& svg, const SphereView& view, const SphericalScene::Paths& paths, const std::string& front,
                const std::string& back, bool antipodes) {
  const auto draw = [&](const std::vector<Vector3>& path) {
    const auto pieces = view.pieces(path);
    for (const auto& piece : pieces.back) svg.polyline(piece, back);
    for (const auto& piece : pieces.front) svg.polyline(piece, front);
  };
  for (std::vector<Vector3> path : paths) {
    draw(path);
    if (!antipodes) continue;
    for (Vector3& axis : path) axis = -axis;
    draw(path);
  }
}

void draw_sphere(SvgCanvas& svg, const SphereView& view) {
  svg.circle(view.center(), view.radius(), fill(palette::page, 0.55) + " " + stroke(palette::line, 1.2));
  for (const Vector3 normal : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}})
    for (const auto& piece : view.pieces(great_circle(normal)).front) svg.polyline(piece, stroke(palette::line, 0.8));
}

std::string faint(const std::string& attributes) { return attributes + " stroke-opacity=\"0.45\""; }

void draw_cones(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene) {
  draw_paths(svg, view, scene.fixed_cone, fixed_cone_stroke(), faint(stroke(palette::curve, 0.7)), true);
  draw_paths(svg, view, scene.moving_cone, moving_cone_stroke(), faint(stroke(palette::curve, 0.7, "4 3")), true);
}

/// A link as a great-circle arc: broad where it is seen.
void draw_arc(SvgCanvas& svg, const SphereView& view, Vector3 from, Vector3 to, std::string_view color) {
  const auto pieces = view.pieces(great_arc(from, to));
  for (const auto& piece : pieces.back) svg.polyline(piece, stroke(color, 1.6, "5 4") + " stroke-opacity=\"0.6\"");
  for (const auto& piece : pieces.front)
    svg.polyline(piece, stroke(color, link_width) + " stroke-linecap=\"round\" stroke-linejoin=\"round\"");
}

void draw_ground_arc(SvgCanvas& svg, const SphereView& view, const SphericalFourBar& bars) {
  const auto pieces = view.pieces(great_arc(bars.input_fixed, bars.output_fixed));
  for (const auto& piece : pieces.back) svg.polyline(piece, faint(stroke(palette::ink3, 0.8, "9 3 2 3")));
  for (const auto& piece : pieces.front) svg.polyline(piece, stroke(palette::ink3, 1.3, "9 3 2 3"));
}

SphericalFourBar in_orientation(const SphericalFourBar& bars, const std::vector<PrescribedOrientation>& orientations,
                                std::size_t j) {
  const UnitQuaternion& from = orientations.front().orientation;
  const UnitQuaternion& to = orientations[j].orientation;
  return {bars.input_fixed, turned(bars.input_moving, from, to), turned(bars.output_moving, from, to),
          bars.output_fixed};
}

/// The links in the other orientations as thin arcs.
void draw_ghosts(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene) {
  svg.begin_group("stroke-opacity=\"0.5\"");
  for (std::size_t j = 1; j < scene.orientations.size(); ++j) {
    const SphericalFourBar there = in_orientation(*scene.bars, scene.orientations, j);
    const auto draw = [&](Vector3 from, Vector3 to, std::string_view color) {
      for (const auto& piece : view.pieces(great_arc(from, to)).front) svg.polyline(piece, stroke(color, 1.2));
    };
    draw(there.input_fixed, there.input_moving, palette::input);
    draw(there.output_fixed, there.output_moving, palette::output);
    draw(there.input_moving, there.output_moving, palette::body);
  }
  svg.end_group();
}

/// A body's triad at its marker, with the number of the orientation on a disc; position 1 names its axes.
void draw_orientation(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene, std::size_t j) {
  constexpr double arm = 30, disc = 8.5;
  const bool strong = j == 0;
  const UnitQuaternion& there = scene.orientations[j].orientation;
  const Vector3 place = turned(scene.marker, scene.orientations.front().orientation, there);
  const Point origin = view.to_px(place);
  const std::string_view color = strong ? palette::ink : palette::ink2;
  svg.begin_group(view.is_in_front(place) ? "" : "opacity=\"0.45\"");
  constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 axis;
    axis[k] = 1;
    const Point along = view.across(there.apply(axis)) / view.radius();
    const Point tip = origin + arm * along;
    svg.line(origin, tip, stroke(color, strong ? 1.8 : 1.2) + " stroke-linecap=\"round\"");
    if (strong && std::abs(along) * arm > 1.5 * disc)
      svg.text(tip + 6.5 * along / std::abs(along) + Point{0, 3.5}, names[k],
               {.size = 10.5, .color = color, .anchor = "middle", .halo = palette::paper});
  }
  svg.circle(origin, disc, fill(strong ? palette::ink : palette::paper) + " " + stroke(color, 1.4));
  svg.text(origin + Point{0, 4}, fmt::format("{}", j + 1),
           {.size = 11, .color = strong ? palette::paper : palette::ink, .anchor = "middle", .weight = 650});
  svg.end_group();
}

/// The dot alone, where there is no room for a triad.
void draw_orientation_dot(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene, std::size_t j) {
  const Vector3 place = turned(scene.marker, scene.orientations.front().orientation, scene.orientations[j].orientation);
  svg.circle(view.to_px(place), 3.2,
             fill(j == 0 ? palette::ink : palette::paper) + " " + stroke(palette::ink2, 1.2) +
                 (view.is_in_front(place) ? "" : " opacity=\"0.45\""));
}

struct NamedAxis {
  Vector3 axis;
  std::string_view name, color;
  bool fixed;
};

std::array<NamedAxis, 4> named_axes(const SphericalFourBar& bars) {
  return {{{bars.input_fixed, "G₁", palette::input, true},
           {bars.output_fixed, "G₂", palette::output, true},
           {bars.input_moving, "W₁", palette::input, false},
           {bars.output_moving, "W₂", palette::output, false}}};
}

void draw_axes(SvgCanvas& svg, const SphereView& view, const SphericalFourBar& bars) {
  for (const NamedAxis& one : named_axes(bars)) {
    const Point at = view.to_px(one.axis);
    svg.begin_group(view.is_in_front(one.axis) ? "" : "opacity=\"0.45\"");
    if (one.fixed) draw_ground_symbol(svg, at);
    draw_pin(svg, at, one.color);
    svg.end_group();
  }
}

/// A few dyads: their axes as beads, either sense that is seen.
void draw_dyads(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene) {
  const auto seen = [&](Vector3 axis) { return view.to_px(view.is_in_front(axis) ? axis : -axis); };
  for (std::size_t i = 0; i < scene.dyads.size(); ++i) {
    svg.circle(seen(scene.dyads[i].fixed_axis), 4, fill(palette::paper) + " " + stroke(palette::ink2, 1.5));
    svg.circle(seen(scene.dyads[i].moving_axis), 4, fill(palette::ink2));
    if (view.radius() < small_radius) continue;
    for (const Vector3 axis : {scene.dyads[i].fixed_axis, scene.dyads[i].moving_axis})
      svg.text(seen(axis) + Point{9, 4}, fmt::format("{}", i + 1),
               {.size = 11, .color = palette::ink2, .halo = palette::paper});
  }
}

void add_points(std::vector<Point>& found, const SphereView& view, std::span<const Vector3> path) {
  for (const Vector3 v : path) found.push_back(view.to_px(v));
}

/// What names keep clear of.
std::vector<Point> obstacles_of(const SphereView& view, const SphericalScene& scene) {
  std::vector<Point> found;
  const SphericalFourBar& bars = *scene.bars;
  add_points(found, view, great_arc(bars.input_fixed, bars.input_moving));
  add_points(found, view, great_arc(bars.input_moving, bars.output_moving));
  add_points(found, view, great_arc(bars.output_moving, bars.output_fixed));
  add_points(found, view, great_arc(bars.input_fixed, bars.output_fixed));
  for (const Vector3 fixed : {bars.input_fixed, bars.output_fixed})
    for (const double down : {8.0, 16.0, 22.0})
      for (const double side : {-10.0, 0.0, 10.0}) found.push_back(view.to_px(fixed) + Point{side, down});
  for (std::size_t j = 0; j < scene.orientations.size(); ++j)
    add_points(
        found, view,
        std::array{turned(scene.marker, scene.orientations.front().orientation, scene.orientations[j].orientation)});
  return found;
}

void draw_names(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene) {
  PointNames names(obstacles_of(view, scene));
  for (const NamedAxis& one : named_axes(*scene.bars)) names.draw(svg, view.to_px(one.axis), one.name, one.color);
}

/// Both curves of a cone by branches, `axis` one of a dyad's.
SphericalScene::Paths branches_of(const std::vector<SphericalDyad>& polygon, const std::vector<CurveBranch>& branches,
                                  Vector3 SphericalDyad::*axis) {
  SphericalScene::Paths paths(branches.size());
  for (const SphericalDyad& dyad : polygon)
    for (std::size_t i = 0; i < branches.size(); ++i)
      if (dyad.coordinate >= branches[i].from && dyad.coordinate < branches[i].to) paths[i].push_back(dyad.*axis);
  return paths;
}

void add_motion(SphericalScene& scene, const SphericalAnalysis& analysis) {
  scene.path = coupler_path(analysis, scene.marker);
  if (!analysis.input_range.is_full_turn() && !scene.path.empty())
    scene.dead_points = {scene.path.front(), scene.path.back()};
}

Vector3 middle(Vector3 a, Vector3 b) { return norm(a + b) > 1e-6 ? normalized(a + b) : a; }

}  // namespace

SphericalScene scene_of(const SphericalAnswer& answer, const std::vector<PrescribedOrientation>& orientations) {
  SphericalScene scene;
  scene.orientations = orientations;
  for (const SphericalDyadPoint& point : answer.given.points) scene.dyads.push_back(point.dyad);
  if (answer.given.curve) {
    const auto polygon = answer.given.curve->polygon();
    scene.moving_cone = branches_of(polygon, answer.given.curve->branches(), &SphericalDyad::moving_axis);
    scene.fixed_cone = branches_of(polygon, answer.given.curve->branches(), &SphericalDyad::fixed_axis);
  }
  scene.marker = normalized(usual_view);
  if (answer.linkages.empty()) return scene;
  scene.bars = answer.linkages.front().four_bar;
  scene.marker = middle(scene.bars->input_moving, scene.bars->output_moving);
  add_motion(scene, analyze(*scene.bars, orientations));
  return scene;
}

SphericalScene scene_of(const StoredSphericalFourBar& linkage) {
  SphericalScene scene;
  scene.bars = linkage.four_bar;
  scene.orientations = linkage.orientations;
  scene.marker = middle(linkage.four_bar.input_moving, linkage.four_bar.output_moving);
  add_motion(scene, analyze(linkage.four_bar, linkage.orientations));
  return scene;
}

SphereView front_view(const SphericalScene& scene, Point center, double radius) {
  if (!scene.bars) return {center, radius, normalized(usual_view), {-usual_view.y, usual_view.x, 0}};
  const SphericalFourBar& bars = *scene.bars;
  const Vector3 sum = bars.input_fixed + bars.input_moving + bars.output_moving + bars.output_fixed;
  const Vector3 towards = norm(sum) > 1e-3 ? normalized(sum) : bars.input_moving;
  return {center, radius, towards, bars.output_fixed - bars.input_fixed};
}

SphereView view_from_above(const SphereView& front, Point center, double radius) {
  constexpr double elevation = radians(60);
  return {center, radius, std::sin(elevation) * front.up() + std::cos(elevation) * front.towards(), front.right()};
}

void draw_scene(SvgCanvas& svg, const SphereView& view, const SphericalScene& scene) {
  const bool is_small = view.radius() < small_radius;
  draw_sphere(svg, view);
  draw_cones(svg, view, scene);
  draw_dyads(svg, view, scene);
  draw_paths(svg, view, {scene.path}, marker_path_stroke(), faint(marker_path_stroke()), false);
  for (const Vector3 dead : scene.dead_points)
    svg.circle(view.to_px(dead), 3.6, fill(palette::bad) + (view.is_in_front(dead) ? "" : " opacity=\"0.45\""));
  if (scene.bars) {
    if (!scene.orientations.empty() && !is_small) draw_ghosts(svg, view, scene);
    draw_ground_arc(svg, view, *scene.bars);
    draw_arc(svg, view, scene.bars->input_moving, scene.bars->output_moving, palette::body);
    draw_arc(svg, view, scene.bars->input_fixed, scene.bars->input_moving, palette::input);
    draw_arc(svg, view, scene.bars->output_fixed, scene.bars->output_moving, palette::output);
  }
  for (std::size_t j = scene.orientations.size(); j-- > 0;)
    is_small ? draw_orientation_dot(svg, view, scene, j) : draw_orientation(svg, view, scene, j);
  if (!scene.bars) return;
  draw_axes(svg, view, *scene.bars);
  draw_names(svg, view, scene);
}

void draw_caption(SvgCanvas& svg, const SphereView& view, std::string_view words) {
  constexpr double below = 46;
  svg.text(view.center() + Point{0, view.radius() + below}, words,
           {.size = 12, .color = palette::ink2, .anchor = "middle"});
}

void draw_views(SvgCanvas& svg, const SphericalScene& scene, Point front_center, Point above_center, double radius) {
  const SphereView front = front_view(scene, front_center, radius);
  const SphereView above = view_from_above(front, above_center, radius);
  constexpr double beside_caption = 152;
  for (const SphereView& view : {front, above}) {
    draw_scene(svg, view, scene);
    draw_fixed_frame(svg, view, view.center() + Point{-std::max(radius - 16, beside_caption), radius + 32});
  }
  draw_caption(svg, front, front_view_words);
  draw_caption(svg, above, view_from_above_words);
}

void draw_dead_point_key(SvgCanvas& svg, Point left) {
  svg.circle(left + Point{15, 0}, 3.6, fill(palette::bad));
  svg.text(left + Point{37, 4}, "dead point of the input", {.size = 12, .color = palette::ink2});
}

void draw_fixed_frame(SvgCanvas& svg, const SphereView& view, Point origin) {
  constexpr double arm = 26;
  constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 axis;
    axis[k] = 1;
    const Point along = view.across(axis) / view.radius();
    svg.line(origin, origin + arm * along, stroke(palette::ink3, 1.4) + " stroke-linecap=\"round\"");
    const double length = std::abs(along);
    svg.text(origin + (arm + 8 / std::max(length, 0.5)) * along + Point{0, 4}, names[k],
             {.size = 11, .color = palette::ink3, .anchor = "middle", .halo = palette::paper});
  }
}

std::string moving_cone_stroke() { return stroke(palette::curve, 1.5, "5 4"); }
std::string fixed_cone_stroke() { return stroke(palette::curve, 1.5); }
std::string marker_path_stroke() { return stroke(palette::accent, 2, "0.1 4.5") + " stroke-linecap=\"round\""; }

}  // namespace linkwright
