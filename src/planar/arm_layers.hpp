#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "arm_choice.hpp"

namespace linkwright {

/// How the elbow stands at the points without an angle, and which of the further dyads.
struct ArmLayer {
  std::uint8_t pattern = 0;  ///< ElbowPattern::bits
  std::size_t dyad = 0;
};

/// How the linkages at a place of a map are told apart by the coordinates of each.
class ArmLayers {
 public:
  ArmLayers(const ArmTask& task, const ArmChoice& choice);

  /// MapAxis::layers of the input's axis.
  [[nodiscard]] int on_input_axis() const { return of_ == LayersOf::input_axis ? static_cast<int>(count_) : 0; }

  /// Which one coordinates name; nothing where that is the best of the place.
  [[nodiscard]] std::optional<ArmLayer> at(MapPoint place) const;
  /// The coordinates of one of those at a place.
  [[nodiscard]] MapPoint in(MapPoint place, ArmLayer layer) const;
  /// The place itself. It has the same bits whichever of its linkages is named, though a layer far on leaves a
  /// coordinate fewer digits.
  [[nodiscard]] MapPoint without(MapPoint place) const;

 private:
  [[nodiscard]] ArmLayer layer(double index) const;

  LayersOf of_;
  std::size_t dyads_of_pattern_, count_;
};

}  // namespace linkwright
