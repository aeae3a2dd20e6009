#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "attitude/finite_rotation.hpp"
#include "drawing/palette.hpp"
#include "euler_angles_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"
#include "linkwright/files/number_text.hpp"
#include "space_figure.hpp"

namespace linkwright {
namespace {

constexpr double rotation_width = 640, rotation_height = 560;
constexpr std::string_view before = palette::ink3, after = palette::input, turn_color = palette::output,
                           vector_color = palette::good;

std::string vector_text(Vector3 v) {
  return fmt::format("({}, {}, {})", significant_text(v.x, 3), significant_text(v.y, 3), significant_text(v.z, 3));
}

/// The turn that is drawn: as given where that is at most one revolution.
AxisAngle drawn_turn(const OrientationReport& report) {
  const auto& given = report.task.orientation.turn;
  return given && std::abs(given->angle()) <= two_pi ? *given : report.turn;
}

/// A vector at an angle to the axis, off the middle of the near side by `turned`, so that the way to its image lies
/// there.
Vector3 vector_on_cone(const AxisAngle& turn, double cone, double turned) {
  const Vector3 p = turn.axis();
  Vector3 across = towards_viewer() - dot(towards_viewer(), p) * p;
  if (norm(across) < 1e-3) across = cross(p, Vector3{0, 0, 1});
  const Vector3 middle = std::cos(cone) * p + std::sin(cone) * normalized(across);
  const auto back = AxisAngle::of(p, turned - turn.angle() / 2);
  return back ? 1.25 * back->quaternion().apply(middle) : middle;
}

/// How far the tips of a vector and of its image lie, in the picture, from all the arrows that are there already.
double separation(const AxisAngle& turn, Vector3 a0) {
  const FiniteRotation tensor(turn);
  std::vector<Vector3> arrows = {turn.axis()};
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    arrows.push_back(unit_vector(axis));
    arrows.push_back(tensor.apply(unit_vector(axis)));
  }
  double least = 10;
  for (const Point tip : {seen(a0), seen(tensor.apply(a0))}) {
    least = std::min(least, std::abs(tip));
    for (const Vector3 arrow : arrows) {
      const Point other = seen(arrow);
      if (dot(tip, other) > 0) least = std::min(least, std::abs(cross(tip, other)) / std::abs(other));
    }
  }
  return least;
}

/// A vector whose way to its image can be seen well.
Vector3 telling_vector(const AxisAngle& turn) {
  Vector3 best = vector_on_cone(turn, 0.75, 0);
  for (const double cone : {0.65, 0.75, 0.85}) {
    for (const double turned : {-0.6, -0.4, -0.2, 0.0, 0.2, 0.4, 0.6}) {
      const Vector3 a0 = vector_on_cone(turn, cone, turned);
      if (separation(turn, a0) > separation(turn, best) + 1e-9) best = a0;
    }
  }
  return best;
}

Vector3 shown_vector(const OrientationReport& report, const AxisAngle& turn) {
  const bool is_given = !report.task.vectors.empty() && !(report.task.vectors.front() == Vector3{});
  return is_given ? 1.25 * normalized(report.task.vectors.front()) : telling_vector(turn);
}

/// The axis, the cone's rim with the way of the vector's tip, the angle between its two radii.
void draw_turn(SpaceFigure& figure, const AxisAngle& turn, Vector3 a0) {
  const Vector3 p = turn.axis(), center = dot(p, a0) * p, image = FiniteRotation(turn).apply(a0);
  figure.line(-0.4 * p, 1.3 * p, turn_color, 1.6, "9 3 2 3");
  figure.arrow(1.3 * p, 1.75 * p, turn_color, 1.6);
  figure.label(1.75 * p, "p", turn_color);
  const auto rim = helix(center, p, a0 - center, two_pi), way = helix(center, p, a0 - center, turn.angle());
  figure.path(rim, palette::curve, 1, "2 3");
  if (norm(a0 - center) > 0.05) {
    figure.sector(center, way, turn_color);
    figure.line(center, a0, turn_color, 1);
    figure.line(center, image, turn_color, 1);
    figure.arrow_along(way, turn_color, 2);
    const auto arc = helix(center, p, 0.35 * (a0 - center), turn.angle());
    figure.path(arc, turn_color, 1.4);
    figure.label(arc[arc.size() / 2], "θ", turn_color, center, 16);
  }
  figure.arrow({}, a0, vector_color, 1.6, "5 3");
  figure.arrow({}, image, vector_color, 2.2);
  figure.label(a0, "a₀", vector_color);
  figure.label(image, "a", vector_color);
}

std::string draw_finite_rotation(const OrientationReport& report) {
  const AxisAngle turn = drawn_turn(report);
  const Vector3 p = turn.axis(), a0 = shown_vector(report, turn), center = dot(p, a0) * p;
  const std::string title =
      turn.axis_defined() ? fmt::format("Rotation by θ = {} about p = {}", degrees_text(turn.angle()), vector_text(p))
                          : "No rotation: the two triads coincide";
  std::vector<Vector3> points = helix(center, p, a0 - center, two_pi);
  points.insert(points.end(), {{}, 1.75 * p, -0.4 * p, center});
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    points.push_back(1.15 * unit_vector(axis));
    points.push_back(1.15 * report.task.orientation.rotation.apply(unit_vector(axis)));
  }
  SvgCanvas svg(rotation_width, rotation_height, title);
  svg.rectangle({0, 0}, rotation_width, rotation_height, fill(palette::paper));
  svg.text({20, 32}, fit_text(title, 17, rotation_width - 40), {.size = 17, .weight = 650});
  SpaceFigure figure(svg, {10, 44, rotation_width - 20, rotation_height - 84}, points, 34);
  figure.triad({}, 1.15, before, 1.6, {"x₀", "y₀", "z₀"});
  figure.triad({report.task.orientation.rotation, {}}, 1.15, after, 2.2, {"x₁", "y₁", "z₁"});
  if (turn.axis_defined()) draw_turn(figure, turn, a0);
  figure.dot({}, palette::ink);
  figure.finish();
  svg.text({20, rotation_height - 16},
           "grey: frame 0, before; blue: frame 1, after the rotation; a = A·a₀ moves on a cone about p",
           {.size = 13, .color = palette::ink2});
  return svg.file();
}

}  // namespace

std::string draw_orientation(const OrientationReport& report) {
  const auto& euler = report.task.orientation.euler;
  return euler ? draw_euler_angles(*euler) : draw_finite_rotation(report);
}

}  // namespace linkwright
