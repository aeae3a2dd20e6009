#include "files/function/function_label.hpp"

#include <fmt/format.h>

namespace linkwright {
namespace {

std::string on_points(const WantedFunction& wanted) {
  const std::string counted = fmt::format("{} precision points", position_count(wanted.pairs));
  const std::string multiplicities = pattern(wanted.pairs);
  return multiplicities.find("PP") == std::string::npos ? counted : fmt::format("{} ({})", counted, multiplicities);
}

struct AxisWords {
  std::string name, title, unit;
};

AxisWords coupler_words(AxisQuantity quantity) {
  if (quantity == AxisQuantity::burmester_point) return {"coupler, one of a few", "Linkage", "1"};
  return {"coupler, coordinate on its curve", "Coupler's coordinate on its curve, τ", "tau"};
}

AxisWords free_words(AxisQuantity quantity, const WantedFunction& wanted) {
  if (quantity == AxisQuantity::output_scale) return {"output scale", "Output scale", "1"};
  if (quantity != AxisQuantity::pair_output) return {"nothing is free", "", "1"};
  const std::string name = fmt::format("output angle of pair {}", wanted.free ? wanted.free->pair + 1 : 1);
  return {name, "O" + name.substr(1) + ", degrees", "deg"};
}

}  // namespace

std::string function_label(const WantedFunction& wanted) {
  std::string what = "function";
  if (wanted.function)
    what += wanted.function->table.empty() ? " " + wanted.function->expression
                                           : fmt::format(" of a table with {} rows", wanted.function->table.size());
  std::string text = fmt::format("{} on {}", what, on_points(wanted));
  if (!wanted.free) return text;
  return text + (wanted.free->kind == FreeParameter::Kind::output_scale
                     ? ", the output scale free"
                     : fmt::format(", the output of pair {} free", wanted.free->pair + 1));
}

std::string short_function_label(const WantedFunction& wanted) {
  return fmt::format("function on {} precision points", position_count(wanted.pairs));
}

AxisLabel generator_axis_label(MapAxis axis, Side side, const WantedFunction& wanted) {
  AxisWords words = side == Side::input ? coupler_words(axis.quantity) : free_words(axis.quantity, wanted);
  return {std::move(words.name), std::move(words.title), std::move(words.unit), name(axis.quantity),
          std::move(axis.branches)};
}

}  // namespace linkwright
