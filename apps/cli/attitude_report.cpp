#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

constexpr int decimals = 6;

/// Six decimals, or as many digits where those would say nothing.
std::string number(double value) {
  const double size = std::abs(value);
  if (size != 0 && (size < 1e-4 || size >= 1e7)) return fmt::format("{:.6g}", value);
  return rounded_text(value, decimals);
}

/// A length, rate or coordinate; what rounding left of a zero, beside `scale`, is a zero.
std::string quantity(double value, double scale = 0, int digits = 7) {
  return significant_text(std::abs(value) <= 1e-14 * scale ? 0 : value, digits);
}

/// Four decimals of a degree, or as many digits where those would say nothing.
std::string angle(double value) {
  const double shown = degrees(value);
  return (shown != 0 && std::abs(shown) < 1e-3 ? fmt::format("{:.5g}", shown) : rounded_text(shown, 4)) + "°";
}

std::string vector(Vector3 v, int digits = 7) {
  const double scale = norm(v);
  return fmt::format("({}, {}, {})", quantity(v.x, scale, digits), quantity(v.y, scale, digits),
                     quantity(v.z, scale, digits));
}

/// "  label:    content".
std::string row(std::string_view label, std::string_view content) {
  return fmt::format("{:<27}{}\n", fmt::format("{}:", label), content);
}

/// Elements that are rounding beside those of 1 are zeros.
double clean(double value, double scale) { return std::abs(value) <= 4e-16 * scale ? 0 : value; }

/// A table without headings.
template <class Rows>
std::string matrix_text(const Rows& rows, std::size_t width, double scale = 1) {
  TextTable table(std::vector<std::string>(width, ""));
  for (const auto& line : rows) {
    std::vector<std::string> cells;
    for (std::size_t j = 0; j < width; ++j) cells.push_back(number(clean(line[j], scale)));
    table.add_row(std::move(cells));
  }
  const std::string text = table.text();
  return text.substr(text.find('\n') + 1);
}

std::string quaternion_text(const UnitQuaternion& quaternion) {
  const UnitQuaternion q = quaternion.canonical();
  return fmt::format("({}, {}, {}, {})", number(q.w()), number(q.v().x), number(q.v().y), number(q.v().z));
}

/// A unit vector.
std::string direction_text(Vector3 v) {
  return fmt::format("({}, {}, {})", rounded_text(v.x, decimals), rounded_text(v.y, decimals),
                     rounded_text(v.z, decimals));
}

/// A vector that may be small as a whole.
std::string small_text(Vector3 v) { return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z)); }

std::string turn_words(const OrientationReport& report) {
  const AxisAngle& turn = report.turn;
  if (!turn.axis_defined()) return "No rotation: the axis is undefined.\n";
  return wrapped(fmt::format("Rotation by {} about the axis {}", angle(turn.angle()), direction_text(turn.axis())));
}

using Decompositions = std::vector<const EulerDecomposition*>;

/// What singular sequences leave open, in a sentence; they agree in what they leave.
std::string lock_sentence(const Decompositions& locked) {
  std::string list;
  for (std::size_t i = 0; i < locked.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == locked.size() ? " and " : ", ") + locked[i]->angles.sequence.name();
  }
  const EulerDecomposition& found = *locked.front();
  return wrapped(
      fmt::format("Gimbal lock of {}: the first and the third axis coincide, so that only first {} third = {} "
                  "is determined; third was set to 0.",
                  list, found.determined_sign > 0 ? "+" : "−", angle(found.determined)));
}

bool leave_the_same(const EulerDecomposition& a, const EulerDecomposition& b) {
  return a.determined_sign == b.determined_sign && angle(a.determined) == angle(b.determined);
}

std::string near_sentence(const EulerDecomposition& found) {
  return wrapped(
      fmt::format("Near gimbal lock of {} (distance {}): first and third are uncertain, first {} third = {} is not.",
                  found.angles.sequence.name(), significant_text(found.lock_distance, 3),
                  found.determined_sign > 0 ? "+" : "−", angle(found.determined)));
}

std::string lock_words(const OrientationReport& report) {
  std::string text;
  std::vector<Decompositions> locked;
  for (const EulerDecomposition& found : report.euler) {
    if (found.singularity == Singularity::none) {
      if (found.is_near_gimbal_lock()) text += near_sentence(found);
      continue;
    }
    const auto alike = std::find_if(locked.begin(), locked.end(),
                                    [&](const Decompositions& group) { return leave_the_same(*group.front(), found); });
    alike == locked.end() ? locked.push_back({&found}) : alike->push_back(&found);
  }
  for (const Decompositions& group : locked) text += lock_sentence(group);
  return text;
}

std::string sequence_table(const OrientationReport& report) {
  TextTable table({"<sequence", "first", "second", "third", "from lock"});
  for (const EulerDecomposition& found : report.euler) {
    const EulerAngles& angles = found.angles;
    const bool locked = found.singularity == Singularity::gimbal_lock;
    table.add_row({angles.sequence.name(), angle(angles.first), angle(angles.second), angle(angles.third),
                   locked ? "locked" : significant_text(found.lock_distance, 3)});
  }
  return "Three rotations about moving (intrinsic) axes (about fixed axes: the same in reverse order):\n" +
         table.text();
}

std::string image_words(const OrientationReport& report) {
  std::string text;
  for (std::size_t i = 0; i < report.images.size(); ++i) {
    text +=
        wrapped(fmt::format("Vector {} is rotated to {}.", vector(report.task.vectors[i]), vector(report.images[i])));
  }
  return text;
}

std::string property_words(const OrientationReport& report) {
  std::string text;
  if (const auto& distance = report.task.orientation.nearest_distance) {
    text = fmt::format("The nearest rotation to the matrix given; the distance between them (Frobenius) is {}.",
                       significant_text(*distance, 3));
  }
  return text.empty() ? text : wrapped(text);
}

std::string displacement_matrix(const Displacement& displacement) {
  TextTable table(std::vector<std::string>(4, ""));
  const Matrix4x4 matrix = displacement.matrix();
  const double scale = norm(displacement.translation);
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<std::string> cells;
    for (std::size_t j = 0; j < 3; ++j) cells.push_back(i == 3 ? "0" : number(clean(matrix[i][j], 1)));
    cells.push_back(i == 3 ? "1" : quantity(matrix[i][3], scale));
    table.add_row(std::move(cells));
  }
  const std::string text = table.text();
  return text.substr(text.find('\n') + 1);
}

std::string in_unit(std::string_view unit) { return unit.empty() ? "" : " " + printable(unit); }

std::string screw_words(const Screw& screw, std::string_view unit) {
  const std::string slide = quantity(screw.translation, 0) + in_unit(unit);
  switch (screw.kind) {
    case ScrewKind::identity:
      return "Nothing moves.\n";
    case ScrewKind::pure_translation:
      return wrapped(fmt::format("Pure translation by {} along {}: every line of this direction is a screw axis.",
                                 slide, direction_text(screw.direction)));
    case ScrewKind::half_turn:
    case ScrewKind::general:
      break;
  }
  std::string text = wrapped(
      fmt::format("Rotation by {} about the screw axis and translation by {} along it", angle(screw.angle), slide));
  text += row("Direction of the axis", direction_text(screw.direction));
  text += row("Point of the axis nearest to O", vector(screw.point));
  text += row("Pitch, per radian", quantity(screw.pitch().value_or(0), std::abs(screw.translation)) + in_unit(unit));
  if (screw.kind == ScrewKind::half_turn)
    text += "A half-turn: the opposite direction with the opposite translation is the same displacement.\n";
  return text;
}

std::string twist_axis_words(const InstantaneousScrew& screw, std::string_view unit) {
  const std::string slide = quantity(screw.slide_rate) + in_unit(unit);
  switch (screw.kind) {
    case TwistKind::rest:
      return "At rest.\n";
    case TwistKind::translation:
      return wrapped(
          fmt::format("Translation by {} per unit of time along {}: every line of this direction is an axis.", slide,
                      direction_text(screw.direction)));
    case TwistKind::rotation:
    case TwistKind::screw:
      break;
  }
  std::string text = fmt::format("Instantaneous {}, per unit of time {} rad",
                                 screw.kind == TwistKind::screw ? "screw" : "rotation", quantity(screw.rate));
  text = wrapped(screw.kind == TwistKind::screw ? text + " about its axis and " + slide + " along it"
                                                : text + " about its axis");
  text += row("Direction of the axis", direction_text(screw.direction));
  text += row("Point of the axis nearest to O", vector(screw.point));
  return text + row("Pitch, per radian", quantity(screw.pitch().value_or(0)) + in_unit(unit));
}

std::string moved_words(std::string_view what, const std::vector<Vector3>& from, const std::vector<Vector3>& to) {
  std::string text;
  for (std::size_t i = 0; i < to.size(); ++i) {
    text += wrapped(fmt::format("{} {} moves to {}.", what, vector(from[i]), vector(to[i])));
  }
  return text;
}

std::string motion_table(const AngularMotionReport& report) {
  TextTable table({"<", "<in the fixed frame", "<in the moving frame"});
  table.add_row({"angular velocity", vector(report.task.in_i.velocity), vector(report.in_j.velocity)});
  table.add_row({"angular acceleration", vector(report.task.in_i.acceleration), vector(report.in_j.acceleration)});
  return "In radians per unit of time (and its square):\n" + table.text();
}

/// Three rates in degrees; what rounding left beside `scale` radians is a zero.
std::string rate_cells(const std::array<double, 3>& values, double scale) {
  std::string cells;
  for (const double value : values) {
    const double kept = std::abs(value) <= 1e-13 * scale ? 0 : value;
    cells += (cells.empty() ? "" : ", ") + significant_text(degrees(kept), 6);
  }
  return cells;
}

void add_sequence(TextTable& table, std::string name, const SequenceRates& rates, const AngularMotion& motion) {
  const bool locked = rates.fit.singularity == Singularity::gimbal_lock;
  const EulerAngles& angles = rates.angles;
  const double speed = norm(motion.velocity);
  const auto cell = [](double value) { return rounded_text(degrees(value), 3); };
  table.add_row({std::move(name),
                 fmt::format("{}, {}, {}", cell(angles.first), cell(angles.second), cell(angles.third)),
                 rate_cells(rates.fit.rates.rates, speed),
                 rate_cells(rates.fit.rates.accelerations, std::max(speed * speed, norm(motion.acceleration))),
                 locked ? "locked" : ""});
}

std::string rates_table(const AngularMotionReport& report) {
  TextTable table({"<sequence", "<angles, degrees", "<rates", "<second derivatives", "<"});
  if (report.given)
    add_sequence(table, report.given->angles.sequence.name() + ", given", *report.given, report.task.in_i);
  for (const SequenceRates& rates : report.euler)
    add_sequence(table, rates.angles.sequence.name(), rates, report.task.in_i);
  std::string text = "Three rotations about moving (intrinsic) axes:\n" + table.text();
  const auto lost = std::max_element(report.euler.begin(), report.euler.end(), [](const auto& a, const auto& b) {
    return a.fit.velocity_residual < b.fit.velocity_residual;
  });
  if (lost != report.euler.end() && lost->fit.singularity == Singularity::gimbal_lock) {
    text +=
        wrapped(fmt::format("Gimbal lock: no rates of the locked sequences produce the whole motion; the least-squares "
                            "rates of least norm are shown, which leave out up to {} of the angular velocity.",
                            quantity(lost->fit.velocity_residual)));
  }
  return text;
}

std::string point_words(const AngularMotionReport& report) {
  std::string text;
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const PointMotion& point = report.points[i];
    const AccelerationParts& parts = report.parts[i];
    text += wrapped(fmt::format("The point at {} in the body lies at {}:", vector(report.task.points[i].position),
                                vector(point.position)));
    text += row("  velocity", vector(point.velocity));
    text += row("  acceleration", vector(point.acceleration));
    const std::array<std::pair<std::string_view, Vector3>, 5> named = {{{"    of the origin", parts.of_origin},
                                                                        {"    tangential", parts.tangential},
                                                                        {"    centripetal", parts.centripetal},
                                                                        {"    Coriolis", parts.coriolis},
                                                                        {"    relative", parts.relative}}};
    for (const auto& [name, part] : named) {
      if (!(part == Vector3{})) text += row(name, vector(part));
    }
  }
  return text;
}

std::string link_table(const LinkChainReport& report) {
  TextTable table({"link", "θ", "d", "a", "α", "<origin of its frame", "<its z"});
  for (std::size_t j = 0; j < report.frames.size(); ++j) {
    const HartenbergDenavit& link = report.task.links[j];
    const Displacement& frame = report.frames[j];
    table.add_row({fmt::format("{}", j + 1), angle(link.theta), quantity(link.d), quantity(link.a), angle(link.alpha),
                   vector(frame.translation, 6), vector(frame.apply_to_direction({0, 0, 1}), 4)});
  }
  return table.text();
}

std::string fit_words(const HartenbergDenavitFit& fit, HartenbergDenavitForm form) {
  std::string text = wrapped(
      fmt::format("Hartenberg-Denavit parameters ({}) of the displacement: θ = {}, d = {}, a = {}, α = {}", name(form),
                  angle(fit.link.theta), quantity(fit.link.d), quantity(fit.link.a), angle(fit.link.alpha)));
  if (fit.angle_defect <= 1e-12 && fit.distance_defect <= 1e-12 * (1 + std::abs(fit.link.a) + std::abs(fit.link.d)))
    return text;
  return text +
         wrapped(fmt::format("Four parameters cannot describe it: x and z of the two frames are off a right angle by "
                             "{} (cosine) and {} apart; place the frames differently.",
                             significant_text(fit.angle_defect, 3), significant_text(fit.distance_defect, 3)));
}

}  // namespace

std::string orientation_words(const OrientationReport& report) {
  const StoredOrientation& orientation = report.task.orientation;
  std::string text = turn_words(report) + property_words(report);
  text += "Matrix, columns the axes of the rotated frame:\n" + matrix_text(orientation.rotation.matrix().row, 3);
  text += row("Quaternion (w, x, y, z)", quaternion_text(orientation.quaternion));
  text += row("Rotation vector, radians", small_text(report.rotation_vector.vector()));
  text +=
      row("Rodrigues vector", report.rodrigues ? small_text(report.rodrigues->vector()) : "at infinity (a half-turn)");
  text += row("Modified Rodrigues vector", small_text(report.mrp.vector()));
  return text + sequence_table(report) + lock_words(report) + image_words(report);
}

std::string displacement_words(const DisplacementReport& report) {
  const std::string& unit = report.task.length_unit;
  std::string text = screw_words(report.screw, unit);
  if (report.task.given && std::abs(report.task.given->angle) > pi) {
    text =
        wrapped(fmt::format("Given as a rotation by {}; as a displacement:", angle(report.task.given->angle))) + text;
  }
  text += row("Translation of O", vector(report.task.displacement.translation));
  text += "Matrix:\n" + displacement_matrix(report.task.displacement);
  text += moved_words("Point", report.task.points, report.displaced_points);
  return text + moved_words("Direction", report.task.directions, report.displaced_directions);
}

std::string twist_words(const TwistReport& report) {
  std::string text = twist_axis_words(report.screw, report.task.length_unit);
  text += row("Angular velocity", vector(report.task.twist.angular));
  text += row("Velocity of O", vector(report.task.twist.velocity));
  for (std::size_t i = 0; i < report.velocities.size(); ++i) {
    text += wrapped(
        fmt::format("Point {} has the velocity {}.", vector(report.task.points[i]), vector(report.velocities[i])));
  }
  return text;
}

std::string angular_motion_words(const AngularMotionReport& report) {
  const double speed = norm(report.task.in_i.velocity),
               scale = std::max(speed * speed, norm(report.task.in_i.acceleration));
  std::string text = motion_table(report);
  text += "First derivative of the matrix:\n" + matrix_text(report.derivatives.first.row, 3, speed);
  text += "Second derivative of the matrix:\n" + matrix_text(report.derivatives.second.row, 3, scale);
  const auto four = [](const QuaternionRate& q) {
    return fmt::format("({}, {}, {}, {})", number(q.w), number(q.v.x), number(q.v.y), number(q.v.z));
  };
  text += row("Derivative of quaternion", four(report.quaternion_first));
  text += row("Second derivative", four(report.quaternion_second));
  text += rates_table(report) + point_words(report);
  if (report.after && report.task.step) {
    text += wrapped(fmt::format("After {} at this angular velocity the quaternion is {}.", quantity(*report.task.step),
                                quaternion_text(*report.after)));
  }
  return text;
}

std::string link_chain_words(const LinkChainReport& report) {
  if (report.fit) return fit_words(*report.fit, report.task.form);
  const std::string& unit = report.task.length_unit;
  std::string text = wrapped(fmt::format("Chain of {} {}, {} form{}:", report.frames.size(),
                                         report.frames.size() == 1 ? "link" : "links", name(report.task.form),
                                         unit.empty() ? "" : ", lengths in " + spoken_unit(printable(unit))));
  text += link_table(report);
  text += "Displacement of the last frame:\n" + displacement_matrix(report.frames.back());
  text += screw_words(report.tip, unit);
  return text + moved_words("Point", report.task.points, report.points);
}

}  // namespace linkwright::cli
