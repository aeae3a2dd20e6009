#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drawing/palette.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/number_text.hpp"
#include "space_figure.hpp"

namespace linkwright {
namespace {

constexpr double screw_width = 640, screw_height = 600;
constexpr double max_turns_drawn = 20;
constexpr double farthest_axis = 12;  // in lengths of the origin's way: farther, the picture would show nothing else

/// What is drawn of a displacement.
struct Scene {
  Screw screw;            ///< as given, or as found
  Displacement body;      ///< the moved frame
  double arm = 1;         ///< of the triads
  bool turns = false;     ///< there is one axis
  bool near_axis = true;  ///< and it lies near enough to be shown
  Vector3 start{};        ///< the point whose way is drawn, and its foot on the axis
  Vector3 foot{};
};

Vector3 foot_on_axis(const Screw& screw, Vector3 point) {
  return screw.point + dot(screw.direction, point - screw.point) * screw.direction;
}

Scene scene_of(const DisplacementReport& report) {
  Scene scene{.screw = report.screw, .body = report.task.displacement};
  const auto& given = report.task.given;
  const bool as_given = given && given->angle != 0 && std::abs(given->angle) <= max_turns_drawn * two_pi;
  if (as_given) scene.screw = *given;
  const Screw& screw = scene.screw;
  scene.turns = as_given || report.screw.kind == ScrewKind::general || report.screw.kind == ScrewKind::half_turn;
  const double way = norm(scene.body.translation), radius = norm(foot_on_axis(screw, {}));
  scene.near_axis = scene.turns && radius <= farthest_axis * way;
  const double size = std::max({way, std::abs(screw.translation), scene.near_axis ? radius : 0});
  scene.arm = size > 0 ? 0.38 * size : 1;
  const bool on_axis = radius <= 0.05 * scene.arm;
  if (scene.turns && on_axis) {  // the origin's way would lie on the axis: a point of the body beside it
    scene.near_axis = true;
    const Vector3 p = screw.direction;
    const Vector3 beside = normalized(towards_viewer() - dot(towards_viewer(), p) * p);
    scene.start = scene.arm * (beside == Vector3{} ? normalized(cross(p, Vector3{0, 0, 1})) : beside);
  }
  scene.foot = foot_on_axis(screw, scene.start);
  return scene;
}

std::vector<Vector3> way_of(const Scene& scene) {
  if (!scene.turns) return {scene.start, scene.body.apply_to_point(scene.start)};
  const Screw& screw = scene.screw;
  return helix(scene.foot, screw.direction, scene.start - scene.foot, screw.angle, screw.translation);
}

std::vector<Vector3> extents(const Scene& scene, const std::vector<Vector3>& way) {
  std::vector<Vector3> points = way;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    points.push_back(scene.arm * unit_vector(axis));
    points.push_back(scene.body.apply_to_point(scene.arm * unit_vector(axis)));
  }
  if (!scene.near_axis) return points;
  const Vector3 p = scene.screw.direction;
  const double slide = scene.screw.translation;
  points.push_back(scene.foot + (std::min(0.0, slide) - scene.arm) * p);
  points.push_back(scene.foot + (std::max(0.0, slide) + 1.3 * scene.arm) * p);
  return points;
}

/// The axis, both radii, the angle laid off where the way starts, the slide.
void draw_axis(SpaceFigure& figure, const Scene& scene, const std::vector<Vector3>& way) {
  const Screw& screw = scene.screw;
  const Vector3 p = screw.direction, foot = scene.foot, last = foot + screw.translation * p;
  const double low = std::min(0.0, screw.translation) - scene.arm, high = std::max(0.0, screw.translation);
  figure.line(foot + low * p, foot + high * p + scene.arm * p, palette::output, 1.6, "9 3 2 3");
  figure.arrow(foot + (high + scene.arm) * p, foot + (high + 1.3 * scene.arm) * p, palette::output, 1.6);
  figure.label(foot + (high + 1.3 * scene.arm) * p, "screw axis", palette::output, foot);
  const Vector3 hand = scene.start - foot;
  const auto level = helix(foot, p, hand, std::clamp(screw.angle, -two_pi, two_pi));
  figure.path(level, palette::output, 1, "2 3");
  const auto arc = helix(foot, p, 0.45 * hand, std::clamp(screw.angle, -two_pi, two_pi));
  figure.sector(foot, arc, palette::output);
  figure.arrow_along(arc, palette::output, 1.8);
  figure.label(arc[arc.size() / 2], "θ", palette::output, foot, 16);
  figure.line(foot, way.front(), palette::curve, 1.2);
  figure.dot(foot, palette::output);
  if (scene.start == Vector3{}) figure.label(foot, "c", palette::output, foot + hand);
  figure.line(foot, level.back(), palette::curve, 1.2, "4 3");
  figure.line(last, way.back(), palette::curve, 1.2);
  if (std::abs(screw.translation) > 0.03 * scene.arm) {
    figure.arrow(foot, last, palette::good, 2.4);
    figure.label(0.5 * (foot + last), "s", palette::good, 0.5 * (way.front() + way.back()), 16);
  }
}

std::string title_of(const DisplacementReport& report, const Scene& scene) {
  const std::string unit = report.task.length_unit.empty() ? "" : " " + report.task.length_unit;
  const std::string slide = significant_text(scene.screw.translation, 5) + unit;
  if (scene.turns)
    return fmt::format("Screw: rotation by θ = {} and translation by s = {}", degrees_text(scene.screw.angle), slide);
  return report.screw.kind == ScrewKind::identity ? "Nothing moves" : fmt::format("Pure translation by {}", slide);
}

}  // namespace

std::string draw_displacement(const DisplacementReport& report) {
  const Scene scene = scene_of(report);
  const std::vector<Vector3> way = way_of(scene);
  const std::string title = title_of(report, scene);
  SvgCanvas svg(screw_width, screw_height, title);
  svg.rectangle({0, 0}, screw_width, screw_height, fill(palette::paper));
  svg.text({20, 32}, fit_text(title, 17, screw_width - 40), {.size = 17, .weight = 650});
  SpaceFigure figure(svg, {10, 44, screw_width - 20, screw_height - 84}, extents(scene, way), 36);
  if (scene.near_axis) draw_axis(figure, scene, way);
  figure.triad({}, scene.arm, palette::ink3, 1.6, {"x₁", "y₁", "z₁"});
  figure.triad(scene.body, scene.arm, palette::input, 2.2, {"x₂", "y₂", "z₂"});
  figure.arrow_along(way, palette::ink, 2);
  figure.dot(way.front(), palette::ink);
  if (scene.start == Vector3{}) figure.label({}, "O", palette::ink, scene.arm * Vector3{1, 1, 1});
  figure.finish();
  svg.text({20, screw_height - 16},
           scene.turns && !scene.near_axis ? "grey: before; blue: after; the axis lies too far away to be shown"
                                           : "grey: before; blue: after; black: the path of a point of the body",
           {.size = 13, .color = palette::ink2});
  return svg.file();
}

}  // namespace linkwright
