#include <array>
#include <cmath>
#include <fmt/format.h>

#include "drawing/palette.hpp"
#include "euler_angles_figure.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "space_figure.hpp"

namespace linkwright {
namespace {

constexpr double euler_width = 640, panel_width = 320, panel_height = 292, top = 44,
                 euler_height = top + 2 * panel_height + 34;
constexpr std::array<std::string_view, 4> frame_colors = {palette::ink3, palette::input, palette::good,
                                                          palette::output};
constexpr std::array<std::string_view, 4> subscripts = {"₀", "₁", "₂", "₃"};
constexpr double length = 1, past = 1.32;  // of the axes of triads, and of the axes of turns

/// Three turns about carried axes, and what stands between them.
struct ThreeTurns {
  std::array<Axis, 3> axes;
  std::array<double, 3> angles;
  std::array<std::string_view, 3> names;  ///< of the angles
  std::array<Rotation, 4> frames;         ///< frame 0, and after each turn

  /// Unit vector of the axis of turn k, in frame 0.
  [[nodiscard]] Vector3 axis(std::size_t k) const { return frames[k].apply(unit_vector(axes[k])); }
  /// The vector whose way shows turn k: it meets the next turn's axis, or comes from the one before.
  [[nodiscard]] Vector3 hand(std::size_t k) const { return frames[k].apply(unit_vector(axes[k < 2 ? k + 1 : k - 1])); }
  /// The first axis and the third lie in one line, the two by which angles were told apart.
  [[nodiscard]] bool locked() const { return norm(cross(axis(0), axis(2))) < 2e-7; }
};

std::array<std::string_view, 3> angle_names(const EulerSequence& sequence) {
  const std::string name = sequence.name();
  if (name == "zxz") return {"ψ", "ϑ", "φ"};
  if (name == "xyz") return {"α", "β", "γ"};
  if (name == "zyx") return {"θ", "β", "α"};
  return {"t₁", "t₂", "t₃"};
}

ThreeTurns three_turns(const EulerAngles& given) {
  const bool reversed = given.sequence.turning() == Turning::extrinsic;
  const EulerSequence sequence = reversed ? given.sequence.reversed() : given.sequence;
  ThreeTurns turns{{sequence.first(), sequence.second(), sequence.third()},
                   {given.first, given.second, given.third},
                   angle_names(sequence),
                   {}};
  if (reversed) std::swap(turns.angles[0], turns.angles[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    turns.frames[k + 1] = turns.frames[k] * Rotation::about(turns.axes[k], turns.angles[k]);
  }
  return turns;
}

std::string axis_name(Axis axis, std::size_t frame) {
  constexpr std::string_view letters = "xyz";
  return fmt::format("{}{}", letters[static_cast<std::size_t>(axis)], subscripts[frame]);
}

std::array<std::string, 3> triad_names(std::size_t frame) {
  return {axis_name(Axis::x, frame), axis_name(Axis::y, frame), axis_name(Axis::z, frame)};
}

/// The angle as drawn: whole revolutions left out.
double drawn_angle(double angle) { return std::abs(angle) <= two_pi ? angle : wrap_signed(angle); }

/// The way of a unit vector in turn k, its area, the name of the angle.
void draw_angle(SpaceFigure& figure, const ThreeTurns& turns, std::size_t k, double radius) {
  const auto way = helix({}, turns.axis(k), radius * turns.hand(k), drawn_angle(turns.angles[k]));
  figure.sector({}, way, frame_colors[k + 1]);
  figure.line({}, way.front(), frame_colors[k + 1], 0.9);
  figure.line({}, way.back(), frame_colors[k + 1], 0.9);
  figure.arrow_along(way, frame_colors[k + 1], 1.8);
  figure.label(way[way.size() / 2], std::string(turns.names[k]), frame_colors[k + 1], {}, 15);
}

void draw_axis_of_turn(SpaceFigure& figure, Vector3 axis, std::string_view color) {
  figure.line(-0.35 * axis, past * axis, color, 1.4, "9 3 2 3");
}

/// The names of a triad without that of the axis which the turn leaves where it is.
std::array<std::string, 3> names_but(std::size_t frame, Axis axis) {
  auto names = triad_names(frame);
  names[static_cast<std::size_t>(axis)].clear();
  return names;
}

/// What the panels have to show: the same for all, so that all have the same scale.
std::vector<Vector3> extents(const ThreeTurns& turns) {
  std::vector<Vector3> points;
  for (const Rotation& frame : turns.frames) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) points.push_back(length * frame.apply(unit_vector(axis)));
  }
  for (std::size_t k = 0; k < 3; ++k) points.insert(points.end(), {past * turns.axis(k), -0.35 * turns.axis(k)});
  if (turns.axes[0] == turns.axes[2]) return points;
  const auto ring = helix({}, cross(turns.axis(0), turns.axis(1)), turns.axis(0), two_pi);
  points.insert(points.end(), ring.begin(), ring.end());
  points.push_back(-past * turns.axis(0));
  return points;
}

PixelBox panel(std::size_t number) {
  const bool right = number % 2 == 1, below = number >= 2;
  return {right ? panel_width : 0, below ? top + panel_height : top, panel_width, panel_height};
}

void draw_caption(SvgCanvas& svg, const PixelBox& box, std::string_view text, std::string_view color) {
  svg.text({box.left + 16, box.top + 18}, fit_text(text, 13.5, panel_width - 24),
           {.size = 13.5, .color = color, .weight = 600});
}

PixelBox scene(const PixelBox& box) { return {box.left + 6, box.top + 24, box.width - 12, box.height - 28}; }

void draw_one_turn(SvgCanvas& svg, const ThreeTurns& turns, std::size_t k) {
  const PixelBox box = panel(k);
  draw_caption(svg, box,
               fmt::format("{}. {} = {} about {}", k + 1, turns.names[k], degrees_text(turns.angles[k]),
                           axis_name(turns.axes[k], k)),
               frame_colors[k + 1]);
  SpaceFigure figure(svg, scene(box), extents(turns), 18);
  draw_axis_of_turn(figure, turns.axis(k), frame_colors[k + 1]);
  figure.triad({turns.frames[k], {}}, length, frame_colors[k], 1.4, names_but(k, turns.axes[k]));
  figure.triad({turns.frames[k + 1], {}}, length, frame_colors[k + 1], 2.2, names_but(k + 1, turns.axes[k]));
  figure.label(past * turns.axis(k), axis_name(turns.axes[k], k) + " = " + axis_name(turns.axes[k], k + 1),
               frame_colors[k + 1]);
  draw_angle(figure, turns, k, 0.62);
  figure.finish();
}

/// "x₀ = z₂", with the sign of what has come to lie in one line.
std::string coincidence(const ThreeTurns& turns) {
  return fmt::format("{} = {}{}", axis_name(turns.axes[0], 0), dot(turns.axis(0), turns.axis(2)) > 0 ? "" : "−",
                     axis_name(turns.axes[2], 2));
}

/// What the last panel says of the three axes.
std::string together_caption(const ThreeTurns& turns) {
  if (turns.locked()) {
    return fmt::format("Gimbal lock: {}", coincidence(turns));
  }
  if (turns.axes[0] == turns.axes[2])
    return fmt::format("Together: {} is the line of nodes N", axis_name(turns.axes[1], 1));
  return "The gimbals that make them";
}

/// The axes of the turns with their names; at the lock, two of them as one line.
void draw_axes_together(SpaceFigure& figure, const ThreeTurns& turns) {
  const bool node = turns.axes[0] == turns.axes[2] && !turns.locked();
  for (std::size_t k = 0; k < 3; ++k) {
    if (turns.locked() && k != 1) continue;
    draw_axis_of_turn(figure, turns.axis(k), frame_colors[k + 1]);
    figure.label(past * turns.axis(k), (k == 1 && node ? "N = " : "") + axis_name(turns.axes[k], k),
                 frame_colors[k + 1]);
  }
  if (!turns.locked()) return;
  const Vector3 both = turns.axis(0);
  figure.line(-0.35 * both, past * both, palette::bad, 1.8, "9 3 2 3");
  figure.label(past * both, "axes 1 and 3", palette::bad);
}

std::vector<Vector3> circle(Vector3 normal, Vector3 radius) { return helix({}, normal, radius, two_pi); }

/// A ring in the plane of two unit vectors at right angles.
void draw_ring(SpaceFigure& figure, Vector3 u, Vector3 v, double radius, std::string_view color) {
  figure.path(circle(cross(u, v), radius * u), color, 3);
}

/// Both halves of an axis between two radii: the journals that one ring has in the other.
void draw_journals(SpaceFigure& figure, Vector3 axis, double inner, double outer, std::string_view color) {
  figure.line(inner * axis, outer * axis, color, 5);
  figure.line(-inner * axis, -outer * axis, color, 5);
}

/// Three different axes: the outer ring turns about the first in the frame, the inner ring about the second in the
/// outer ring, the rotor about the third in the inner ring.
void draw_gimbals(SpaceFigure& figure, const ThreeTurns& turns) {
  constexpr double outer = 1.0, inner = 0.78, rotor = 0.5;
  const Vector3 first = turns.axis(0), second = turns.axis(1), third = turns.axis(2);
  draw_ring(figure, first, second, outer, frame_colors[1]);
  draw_ring(figure, second, third, inner, frame_colors[2]);
  const Vector3 mark = rotor * turns.frames[3].apply(unit_vector(turns.axes[1]));
  const auto rim = circle(third, mark);
  figure.sector({}, rim, frame_colors[3]);
  figure.path(rim, frame_colors[3], 3);
  figure.arrow({}, mark, frame_colors[3], 2);
  draw_journals(figure, first, outer, past, frame_colors[1]);
  draw_journals(figure, second, inner, outer, frame_colors[2]);
  figure.line(-inner * third, inner * third, frame_colors[3], 2.4);
  if (turns.locked()) {
    figure.line(-past * first, past * first, palette::bad, 1.8, "9 3 2 3");
    figure.label(past * first, "axes 1 and 3", palette::bad);
  } else {
    figure.label(past * first, "1: " + axis_name(turns.axes[0], 0), frame_colors[1]);
    figure.label(inner * third, "3: " + axis_name(turns.axes[2], 2), frame_colors[3]);
  }
  figure.label(outer * second, "2: " + axis_name(turns.axes[1], 1), frame_colors[2]);
  figure.finish();
}

void draw_together(SvgCanvas& svg, const ThreeTurns& turns) {
  const PixelBox box = panel(3);
  draw_caption(svg, box, together_caption(turns), turns.locked() ? palette::bad : palette::ink);
  SpaceFigure figure(svg, scene(box), extents(turns), 18);
  if (turns.axes[0] != turns.axes[2]) return draw_gimbals(figure, turns);
  auto last = triad_names(3), first = triad_names(0);
  first[static_cast<std::size_t>(turns.axes[0])].clear();  // named as the axis of the first turn
  last[static_cast<std::size_t>(turns.axes[2])].clear();
  figure.triad({turns.frames[0], {}}, length, frame_colors[0], 1.4, first);
  figure.triad({turns.frames[3], {}}, length, frame_colors[3], 2.2, last);
  draw_axes_together(figure, turns);
  for (std::size_t k = 0; k < 3; ++k) draw_angle(figure, turns, k, 0.5 + 0.14 * static_cast<double>(k));
  figure.finish();
}

std::string foot_note(const ThreeTurns& turns) {
  if (!turns.locked()) return "grey, blue, green, rust: frames 0 to 3; each turn carries the next axis along";
  const std::string_view sign = dot(turns.axis(0), turns.axis(2)) > 0 ? "+" : "−";
  return fmt::format("at the lock the turns {} and {} do the same: only {} {} {} is determined", turns.names[0],
                     turns.names[2], turns.names[0], sign, turns.names[2]);
}

}  // namespace

std::string draw_euler_angles(const EulerAngles& angles) {
  const ThreeTurns turns = three_turns(angles);
  const bool proper = turns.axes[0] == turns.axes[2];
  std::string title = fmt::format("{} angles", proper ? "Euler" : "Cardan");
  for (std::size_t k = 0; k < 3; ++k) {
    title += fmt::format("{} {} = {} about {}", k == 0 ? ":" : ",", turns.names[k], degrees_text(turns.angles[k]),
                         axis_name(turns.axes[k], k));
  }
  SvgCanvas svg(euler_width, euler_height, title);
  svg.rectangle({0, 0}, euler_width, euler_height, fill(palette::paper));
  svg.text({16, 28}, fit_text(title, 15, euler_width - 28), {.size = 15, .weight = 650});
  svg.line({16, top + panel_height}, {euler_width - 16, top + panel_height}, stroke(palette::line, 1));
  svg.line({panel_width, top + 4}, {panel_width, top + 2 * panel_height - 4}, stroke(palette::line, 1));
  for (std::size_t k = 0; k < 3; ++k) draw_one_turn(svg, turns, k);
  draw_together(svg, turns);
  svg.text({16, euler_height - 12}, foot_note(turns), {.size = 13, .color = palette::ink2});
  return svg.file();
}

}  // namespace linkwright
