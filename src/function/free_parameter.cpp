#include "linkwright/function/free_parameter.hpp"

#include <cmath>

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 2> free_names = {"output_scale", "pair_output"};

}  // namespace

double FreeParameter::at(double t) const {
  const auto [low, high] = range;
  return kind == Kind::output_scale ? low * std::pow(high / low, t) : low + (high - low) * t;
}

double FreeParameter::place_of(double value) const {
  const auto [low, high] = range;
  return kind == Kind::output_scale ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::string_view name(FreeParameter::Kind kind) { return free_names[static_cast<std::size_t>(kind)]; }

}  // namespace linkwright
