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

struct Words {
  std::string name, title, unit;
};

Words coupler_words(AxisQuantity quantity) {
  if (quantity == AxisQuantity::burmester_point) return {"coupler, one of a few", "Linkage", "1"};
  return {"coupler, place on its curve", "Coupler's place on its curve, τ", "tau"};
}

Words free_words(AxisQuantity quantity, const FunctionTask& task) {
  if (quantity == AxisQuantity::output_scale)
    return {"factor on the output's travel", "Factor on the output's travel", "1"};
  if (quantity != AxisQuantity::pair_output) return {"nothing is free", "", "1"};
  const std::string name = fmt::format("output angle of pair {}", task.free ? task.free->pair + 1 : 1);
  return {name, "O" + name.substr(1) + ", degrees", "deg"};
}

Words side_link_words(const MapAxis& axis, Side side, std::string_view length_unit) {
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

MapAxis axis_of(const FourBarAnswer& answer, Side side) {
  return answer.given.family ? answer.given.family->axis(side) : MapAxis{};
}

AxisLabel label_of(MapAxis axis, Words words) {
  return {std::move(words.name), std::move(words.title), std::move(words.unit), name(axis.quantity),
          std::move(axis.branches)};
}

}  // namespace

AxisLabel axis_label(const MotionAnswer& answer, Side side, std::string_view length_unit) {
  const MapAxis axis = axis_of(answer, side);
  return label_of(axis, side_link_words(axis, side, length_unit));
}

AxisLabel axis_label(const FunctionAnswer& answer, Side side, std::string_view /*length_unit*/) {
  const MapAxis axis = axis_of(answer, side);
  return label_of(axis, side == Side::input ? coupler_words(axis.quantity) : free_words(axis.quantity, answer.task));
}

AxisLabel axis_label(const SixBarAnswer& answer, Side side, std::string_view /*length_unit*/) {
  const int link = side == Side::input ? 4 : 5;
  const BodyPair between = answer.task.added[side == Side::input ? 0 : 1];
  const std::string name = fmt::format("link {} between {} and {}", link, between.a, between.b);
  if (side == Side::output && answer.chain && answer.chain->second_is_share())
    return {name + ", share of its curve, which link 4 decides",
            fmt::format("Link {}: share of its curve", link),
            "1",
            "curve_share",
            {{"", 0, 1}}};
  return {name + ", place on its curve", fmt::format("Link {}: place τ{} on its curve", link, link == 4 ? "₄" : "₅"),
          "tau", linkwright::name(AxisQuantity::curve_coordinate),
          answer.chain ? answer.chain->axis(side).branches : std::vector<CurveBranch>{}};
}

bool has_values(AxisQuantity quantity) {
  return quantity == AxisQuantity::side_direction || quantity == AxisQuantity::side_length ||
         quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output;
}

}  // namespace linkwright
