#include "arm_layers.hpp"

#include <algorithm>
#include <cmath>

#include "arm_kernel.hpp"

namespace linkwright {
namespace {

// Of a coordinate in [0, 1) as many digits as it keeps in the layer farthest on.
double kept_in_layers(double coordinate) {
  constexpr double beyond_all_layers = 128, step = 0x1p-45;
  static_assert(pattern_count(ArmElbows::most_points) * ArmBlock::most_dyads < beyond_all_layers - 1);
  return std::min((coordinate + beyond_all_layers) - beyond_all_layers, 1 - step);
}

}  // namespace

ArmLayers::ArmLayers(const ArmTask& task, const ArmChoice& choice)
    : of_(choice.layers()),
      dyads_of_pattern_(choice.knows_other() ? 1 : ArmBlock::most_dyads),
      count_(pattern_count(task.plain_count()) * dyads_of_pattern_) {}

ArmLayer ArmLayers::layer(double index) const {
  const auto whole = static_cast<std::size_t>(index);
  return {static_cast<std::uint8_t>(whole / dyads_of_pattern_), whole % dyads_of_pattern_};
}

std::optional<ArmLayer> ArmLayers::at(MapPoint place) const {
  switch (of_) {
    case LayersOf::nothing:
      return ArmLayer{};
    case LayersOf::output_branch:
      return layer(std::clamp(place.output, 0.0, static_cast<double>(count_) - 0.5));
    default:
      if (!(place.input >= 1 && place.input < static_cast<double>(count_ + 1))) return std::nullopt;
      return layer(place.input - 1);
  }
}

MapPoint ArmLayers::in(MapPoint place, ArmLayer layer) const {
  const auto index = static_cast<double>(layer.pattern * dyads_of_pattern_ + layer.dyad);
  switch (of_) {
    case LayersOf::nothing:
      return place;
    case LayersOf::output_branch:
      return {place.input, index + 0.5};
    default:
      return {1 + index + without(place).input, place.output};
  }
}

MapPoint ArmLayers::without(MapPoint place) const {
  if (of_ != LayersOf::input_axis || !(place.input >= 0 && place.input < static_cast<double>(count_ + 1))) return place;
  return {kept_in_layers(place.input - std::floor(place.input)), place.output};
}

}  // namespace linkwright
