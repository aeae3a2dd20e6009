#include <fmt/format.h>

#include "files/function/function_label.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/task_label.hpp"
#include "spherical_kind.hpp"

namespace linkwright {
namespace {

constexpr int shown_digits = 6;

}  // namespace

namespace {

/// "four orientations"; where derivatives count, too, "four positions".
std::string orientations_text(const SphericalMotionTask& task) {
  const int count = position_count(task.orientations);
  return count == static_cast<int>(task.orientations.size()) ? count_text(count) + " orientations"
                                                             : positions_text(count);
}

}  // namespace

std::string label_of(const SphericalMotionTask& task) {
  const std::string text =
      fmt::format("{} about a fixed centre ({})", orientations_text(task), pattern(task.orientations));
  if (!task.given) return text;
  return text + (task.given->kind == GivenAxes::Kind::fixed ? ", given fixed axes" : ", given moving axes");
}

std::string short_label_of(const SphericalMotionTask& task) { return orientations_text(task); }

std::string label_of(const SphericalFunctionTask& task) {
  return fmt::format("{}, fixed axes at {}°", function_label(task),
                     significant_text(degrees(task.ground_angle), shown_digits));
}

std::string short_label_of(const SphericalFunctionTask& task) { return short_function_label(task); }

AxisLabel axis_label(const SphericalFunctionAnswer& answer, Side side, std::string_view /*length_unit*/) {
  return generator_axis_label(answer.family() ? answer.family()->axis(side) : MapAxis{}, side, answer.task);
}

AxisLabel axis_label(const SphericalMotionAnswer& answer, Side side, std::string_view /*length_unit*/) {
  const MapAxis axis = answer.family() ? answer.family()->axis(side) : MapAxis{};
  const bool drives = side == Side::input;
  const std::string_view link = drives ? "input link" : "output link", title = drives ? "Input link" : "Output link";
  if (axis.quantity == AxisQuantity::burmester_point)
    return {fmt::format("{}, one of the dyads", link), fmt::format("{}, by its number", title), "1",
            name(axis.quantity), axis.branches};
  return {fmt::format("{}, coordinate on its curve", link), fmt::format("{}, τ{}", title, drives ? "₁" : "₂"), "tau",
          name(axis.quantity), axis.branches};
}

}  // namespace linkwright
