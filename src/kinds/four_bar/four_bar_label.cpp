#include <fmt/format.h>

#include "files/function/function_label.hpp"
#include "four_bar_kind.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"

// How tasks of four-bars, and the axes of their maps, are spoken of.
namespace linkwright {
namespace {

constexpr int digits = 6;

std::string number(double value) { return significant_text(value, digits); }

std::string given_words(const SideLengths& given) {
  if (!given.output) return fmt::format("input link {}", number(given.input));
  return fmt::format("grounded links {} and {}", number(given.input), number(*given.output));
}

std::string given_words(const SideAngle& given) {
  const std::string angle = fmt::format("{} at {}°", given.directed ? "grounded links" : "lines of the grounded links",
                                        number(degrees(given.angle)));
  return given.input_length ? fmt::format("{}, input {}", angle, number(*given.input_length)) : angle;
}

std::string given_words(const InstantCenter& given) {
  const std::string point = fmt::format("({}, {})", number(given.point.real()), number(given.point.imag()));
  return given.at_infinity ? "instant centre at infinity in direction " + point : "instant centre " + point;
}

std::string point_words(Point p) { return fmt::format("({}, {})", number(p.real()), number(p.imag())); }

std::string given_words(const GivenPivots& given) {
  if (given.input && given.output && given.input->kind == given.output->kind)
    return fmt::format("{} pivots {} and {}", name(given.input->kind), point_words(given.input->point),
                       point_words(given.output->point));
  std::string text;
  for (const Side side : {Side::input, Side::output})
    if (const auto& pivot = side == Side::input ? given.input : given.output)
      text += fmt::format("{}{} pivot of the {} link {}", text.empty() ? "" : ", ", name(pivot->kind), name(side),
                          point_words(pivot->point));
  return text;
}

std::string line_words(const LineAtAngle& line) {
  return fmt::format("on the line through {} at {}°", point_words(line.point), number(degrees(line.angle)));
}

std::string given_words(const PivotLines& given) {
  std::string text;
  for (const PivotKind kind : {PivotKind::ground, PivotKind::moving})
    if (const auto& line = kind == PivotKind::ground ? given.ground : given.moving)
      text += fmt::format("{}{} pivots {}", text.empty() ? "" : ", ", name(kind), line_words(*line));
  return text;
}

std::string titled(std::string_view title, std::string_view unit) {
  return unit.empty() ? std::string(title) : fmt::format("{}, {}", title, unit);
}

/// Of three positions between some of which the body only translates: the branches run round a circle.
bool runs_round_a_circle(const MapAxis& axis) {
  if (axis.branches.empty()) return false;
  const std::string& name = axis.branches.front().name;
  return name.rfind("direct", 0) == 0;
}

struct Words {
  std::string name, title, unit;
};

/// A coordinate of a pivot that is looked for: "x of the output link's ground pivot".
Words pivot_words(Side side, AxisQuantity quantity, std::string_view length_unit) {
  const bool ground = quantity == AxisQuantity::center_x || quantity == AxisQuantity::center_y;
  const bool across = quantity == AxisQuantity::center_x || quantity == AxisQuantity::circle_x;
  const std::string words =
      fmt::format("{} of the {} link's {} pivot", across ? "x" : "y", name(side), ground ? "ground" : "moving");
  return {words, titled(words, length_unit), std::string(length_unit)};
}

Side side_looked_for(const MotionTask& task) {
  const auto* given = task.given ? std::get_if<GivenPivots>(&*task.given) : nullptr;
  return given && given->input ? Side::output : Side::input;
}

Words dyad_words(const MotionTask& task, const MapAxis& axis, Side side, std::string_view length_unit) {
  const bool drives = side == Side::input;
  const std::string link = drives ? "input link, " : "output link, ";
  const std::string_view title = drives ? "Input link" : "Output link", index = drives ? "₁" : "₂";
  switch (axis.quantity) {
    case AxisQuantity::burmester_point:
      return {link + (position_count(task.poses) == 5 ? "one of the Burmester points" : "one of the dyads on the line"),
              fmt::format("{}, by its number", title), "1"};
    case AxisQuantity::side_direction:
      return {link + "direction in position 1", fmt::format("{}: direction β{} in position 1, degrees", title, index),
              "deg"};
    case AxisQuantity::side_length:
      return {link + "length", titled(fmt::format("{}: length R{}", title, index), length_unit),
              std::string(length_unit)};
    case AxisQuantity::nothing:
      return {link + "nothing is free", "", "1"};
    case AxisQuantity::fitted_curve:
      return {"one of the nearest linkages", "Linkage, by its number", "1"};
    case AxisQuantity::center_on_line:
    case AxisQuantity::circle_on_line: {
      const std::string_view kind = axis.quantity == AxisQuantity::center_on_line ? "ground" : "moving";
      return {fmt::format("{}place of the {} pivot on the line", link, kind),
              titled(fmt::format("{}: {} pivot along the line, s{}", title, kind, index), length_unit),
              std::string(length_unit)};
    }
    case AxisQuantity::center_x:
    case AxisQuantity::center_y:
    case AxisQuantity::circle_x:
    case AxisQuantity::circle_y:
      return pivot_words(side_looked_for(task), axis.quantity, length_unit);
    default:
      break;
  }
  if (runs_round_a_circle(axis))
    return {link + "position on its circle", fmt::format("{}, position τ{} on its circle", title, index), "tau"};
  return {link + "coordinate on its curve", fmt::format("{}, τ{}", title, index), "tau"};
}

MapAxis axis_of(const FourBarAnswer& answer, Side side) {
  return answer.given.family ? answer.given.family->axis(side) : MapAxis{};
}

AxisLabel label_of(MapAxis axis, Words words) {
  return {std::move(words.name), std::move(words.title), std::move(words.unit), name(axis.quantity),
          std::move(axis.branches)};
}

}  // namespace

namespace {

std::string near_words(const MotionTask& task) {
  const std::size_t near = task.near.size();
  return fmt::format("{} near pose{}", near, near == 1 ? "" : "s");
}

}  // namespace

std::string label_of(const MotionTask& task) {
  if (task.poses.empty()) return near_words(task);
  std::string text = fmt::format("{} ({})", positions_text(position_count(task.poses)), pattern(task.poses));
  if (!task.near.empty()) text += " and " + near_words(task);
  if (task.relaxed) text += fmt::format(", position {} relaxed", *task.relaxed + 1);
  if (task.given) text += ", " + std::visit([](const auto& given) { return given_words(given); }, *task.given);
  for (const PivotOnLine& asked : task.pivots_on)
    text += fmt::format(", {} pivot of the {} link {}", name(asked.pivot), name(asked.side), line_words(asked.line));
  return text;
}

std::string short_label_of(const MotionTask& task) {
  if (task.poses.empty()) return near_words(task);
  const std::string positions = positions_text(position_count(task.poses));
  return task.near.empty() ? positions : positions + " and " + near_words(task);
}

AxisLabel axis_label(const MotionAnswer& answer, Side side, std::string_view length_unit) {
  const MapAxis axis = axis_of(answer, side);
  return label_of(axis, dyad_words(answer.task, axis, side, length_unit));
}

std::string label_of(const FunctionTask& task) { return function_label(task); }
std::string short_label_of(const FunctionTask& task) { return short_function_label(task); }

AxisLabel axis_label(const FunctionAnswer& answer, Side side, std::string_view /*length_unit*/) {
  return generator_axis_label(axis_of(answer, side), side, answer.task);
}

namespace {

std::string pivots_words(const GroundPivots& pivots) {
  const auto& [input, output] = pivots;
  if (input && output) return fmt::format("ground pivots {} and {}", point_words(*input), point_words(*output));
  return fmt::format("ground pivot of the {} link {}", name(input ? Side::input : Side::output),
                     point_words(input ? *input : *output));
}

/// Angles, ground pivots, or both.
std::string given_words(const PathTask& task) {
  const std::string_view link = task.timing() == PathTiming::none ? "coupler" : "crank";
  const std::string angles = task.is_timed()           ? "at given crank angles"
                             : task.angled_count() > 0 ? fmt::format("some at given {} angles", link)
                                                       : "";
  if (task.pivots.count() == 0) return angles;
  return fmt::format("{}{}with given {}", angles, angles.empty() ? "" : " ", pivots_words(task.pivots));
}

}  // namespace

std::string label_of(const PathTask& task) {
  if (task.is_approximate())
    return fmt::format("{} near {} points{}", task.closed ? "closed path" : "path", task.points.size(),
                       task.pivots.count() == 0 ? "" : fmt::format(" with given {}", pivots_words(task.pivots)));
  return fmt::format("path through {} {} ({})", positions_text(position_count(task.points)), given_words(task),
                     pattern(task.points));
}
std::string short_label_of(const PathTask& task) {
  if (task.is_approximate()) return label_of(task);
  return fmt::format("path through {}", positions_text(position_count(task.points)));
}

namespace {

Words arm_axis_words(const PathTask& task, AxisQuantity quantity, std::string_view length_unit) {
  const std::string_view link = task.pivots.input ? "crank" : "output link";
  const Side looked_for = task.form() == PathForm::other_pivot && task.pivots.input ? Side::output : Side::input;
  switch (quantity) {
    case AxisQuantity::arm_reach:
      return {fmt::format("farthest point over {} and arm", link), fmt::format("Farthest point / ({} + arm), u", link),
              "1"};
    case AxisQuantity::arm_difference:
      return {fmt::format("arm less {} over nearest point", link), fmt::format("(Arm − {}) / nearest point, v", link),
              "1"};
    case AxisQuantity::center_x:
    case AxisQuantity::center_y:
      return pivot_words(looked_for, quantity, length_unit);
    case AxisQuantity::layer:
      return {"one of the linkages", "Linkage, by its number", "1"};
    case AxisQuantity::nothing:
      return {"nothing is free", "", "1"};
    case AxisQuantity::fitted_curve:
      return {"one of the nearest paths", "Path, by its number", "1"};
    case AxisQuantity::realisation:
      return {"one of the four-bars with the same path", "Four-bar with this path", "1"};
    default:
      return {"input link, coordinate on its curve", "Input link, τ", "tau"};
  }
}

}  // namespace

AxisLabel axis_label(const PathAnswer& answer, Side side, std::string_view length_unit) {
  MapAxis axis = axis_of(answer, side);
  if (answer.task.form() != PathForm::cranks)
    return label_of(axis, arm_axis_words(answer.task, axis.quantity, length_unit));
  const bool drives = side == Side::input, are_few = axis.quantity == AxisQuantity::burmester_point;
  const std::string_view link = drives ? "crank" : "crank of the cognate", title = drives ? "Crank" : "Cognate's crank";
  AxisLabel label{fmt::format("{}, {}", link, are_few ? "one of the few" : "coordinate on its curve"),
                  are_few ? fmt::format("{}, by its number", title) : fmt::format("{}, τ{}", title, drives ? "₁" : "₂"),
                  are_few ? "1" : "tau", name(axis.quantity), std::move(axis.branches)};
  if (axis.quantity == AxisQuantity::curve_coordinate)
    label.quantity = drives ? "crank_coordinate" : "cognate_coordinate";
  return label;
}

}  // namespace linkwright
