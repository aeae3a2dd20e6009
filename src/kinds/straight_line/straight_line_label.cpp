#include <array>
#include <fmt/format.h>

#include "linkwright/files/task_label.hpp"
#include "straight_line_kind.hpp"

namespace linkwright {
namespace {

struct CaseWords {
  std::string_view key, words;
};
constexpr std::array<CaseWords, 14> case_words = {
    {{"four_point_pivots", "given ground pivots, four points of contact"},
     {"four_point_cubic", "given cubic, four points of contact"},
     {"ball_point_on_side_link", "Ball's point on the line of the output link"},
     {"isosceles_trapezoid", "isosceles trapezoid"},
     {"pole_at_fixed_pivot", "the pole at a ground pivot"},
     {"pole_at_fixed_pivot_ball_point_on_frame", "the pole at a ground pivot, Ball's point on the ground link"},
     {"five_point", "five points of contact"},
     {"five_point_inflection_pole", "five points of contact at the inflection pole"},
     {"five_point_side_link_on_frame", "five points of contact, a side link on the ground link"},
     {"six_point", "six points of contact"},
     {"parallel_side_links", "parallel grounded links, as Watt's"},
     {"mixed", "contacts at given places"},
     {"symmetric_lambda", "symmetric lambda linkage"},
     {"search", "search of all cases"}}};

std::string_view words_of(const StraightLineCase& given) {
  for (const CaseWords& of : case_words)
    if (of.key == name(given)) return of.words;
  return name(given);
}

struct AxisWords {
  AxisQuantity quantity;
  std::string_view name, symbol;  ///< {} is the link
};
constexpr std::array<AxisWords, 13> axis_words = {
    {{AxisQuantity::link_direction, "direction of the {} link's line", "θ{}"},
     {AxisQuantity::link_ray, "ray of the {} link from the pole tangent", "ψ{}"},
     {AxisQuantity::point_ray, "ray of the point from the pole tangent", "ψC"},
     {AxisQuantity::pole_height, "height of the pole off the line", "hP"},
     {AxisQuantity::pivot_height, "height of the {} ground pivot off the line", "hB₀"},
     {AxisQuantity::frame_height, "height of the point off the ground link", "h"},
     {AxisQuantity::pivot_distance, "distance of the {} ground pivot from the pole", "r₀A"},
     {AxisQuantity::output_arm, "length of the output link", "rB"},
     {AxisQuantity::link_length, "length of the {} link", "ρ{}"},
     {AxisQuantity::crank_length, "length of the crank", "r"},
     {AxisQuantity::point_arm, "distance of the point from the crank's pin", "p"},
     {AxisQuantity::crank_range, "crank range", "β"},
     {AxisQuantity::nothing, "nothing is free", ""}}};

const AxisWords& words_of(AxisQuantity quantity) {
  for (const AxisWords& of : axis_words)
    if (of.quantity == quantity) return of;
  return axis_words.back();
}

}  // namespace

std::string label_of(const StraightLineTask& task) { return fmt::format("straight line: {}", words_of(task.given)); }

std::string short_label_of(const StraightLineTask& /*task*/) { return "straight line"; }

AxisLabel axis_label(const StraightLineAnswer& answer, Side side, std::string_view length_unit) {
  const MapAxis axis = answer.family() ? answer.family()->axis(side) : MapAxis{AxisQuantity::nothing, {}};
  const AxisWords& words = words_of(axis.quantity);
  const bool drives = side == Side::input;
  const std::string name = fmt::format(fmt::runtime(words.name), drives ? "input" : "output"),
                    symbol = fmt::format(fmt::runtime(words.symbol), drives ? "A" : "B");
  const std::string unit = axis.quantity == AxisQuantity::nothing ? "1"
                           : is_angle(axis.quantity)              ? "deg"
                                                                  : std::string(length_unit);
  std::string title = symbol.empty() ? name : fmt::format("{} {}", sentence_case(name), symbol);
  if (is_angle(axis.quantity))
    title += ", degrees";
  else if (!unit.empty() && axis.quantity != AxisQuantity::nothing)
    title += ", " + unit;
  std::vector<CurveBranch> branches;
  if (answer.family() && !axis.is_discrete()) {
    const auto [low, high] = answer.family()->range(side);
    branches.push_back({std::string(linkwright::name(axis.quantity)), low, high});
  }
  return {name, title, unit, linkwright::name(axis.quantity), branches};
}

}  // namespace linkwright
