#include "axis_label.hpp"

#include <fmt/format.h>

namespace linkwright {
namespace {

std::string titled(std::string_view title, std::string_view unit) {
  return unit.empty() ? std::string(title) : fmt::format("{}, {}", title, unit);
}

/// Of three positions between some of which the body only shifts: the branches run round a circle.
bool runs_round_a_circle(const MapAxis& axis) {
  if (axis.branches.empty()) return false;
  const std::string& name = axis.branches.front().name;
  return name.rfind("direct", 0) == 0;
}

AxisLabel coupler_label(AxisQuantity quantity) {
  if (quantity == AxisQuantity::burmester_point) return {"coupler, one of a few", "Linkage", "1"};
  return {"coupler, place on its curve", "Coupler's place on its curve, τ", "tau"};
}

AxisLabel free_label(AxisQuantity quantity, const FunctionTask& task) {
  if (quantity == AxisQuantity::output_scale)
    return {"factor on the output's travel", "Factor on the output's travel", "1"};
  if (quantity != AxisQuantity::pair_output) return {"nothing is free", "", "1"};
  const std::string name = fmt::format("output angle of pair {}", task.free ? task.free->pair + 1 : 1);
  return {name, "O" + name.substr(1) + ", degrees", "deg"};
}

AxisLabel side_link_label(const MapAxis& axis, Side side, std::string_view length_unit) {
  const bool drives = side == Side::input;
  const std::string link = drives ? "input side link, " : "output side link, ";
  const std::string_view title = drives ? "Driving side link" : "Other side link", index = drives ? "₁" : "₂";
  switch (axis.quantity) {
    case AxisQuantity::burmester_point:
      return {link + "one of the Burmester points", fmt::format("{}, by its number", title), "1"};
    case AxisQuantity::side_direction:
      return {link + "direction in position 1", fmt::format("{}: direction β{} in position 1, degrees", title, index),
              "deg"};
    case AxisQuantity::side_length:
      return {link + "length", titled(fmt::format("{}: length R{}", title, index), length_unit),
              std::string(length_unit)};
    default:
      break;
  }
  if (runs_round_a_circle(axis))
    return {link + "place round its circle", fmt::format("{}, place τ{} round its circle", title, index), "tau"};
  return {link + "place on its curve", fmt::format("{}, τ{}", title, index), "tau"};
}

}  // namespace

AxisLabel axis_label(const MapAxis& axis, Side side, const Task& task, std::string_view length_unit) {
  const auto* function = std::get_if<FunctionTask>(&task);
  if (function == nullptr) return side_link_label(axis, side, length_unit);
  return side == Side::input ? coupler_label(axis.quantity) : free_label(axis.quantity, *function);
}

bool has_values(AxisQuantity quantity) {
  return quantity == AxisQuantity::side_direction || quantity == AxisQuantity::side_length ||
         quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output;
}

}  // namespace linkwright
