#pragma once

#include <utility>
#include <vector>

#include "linkwright/machine/moving_linkage.hpp"

namespace linkwright {

/// What a body's plate spans in position 1: its hinges, and the traced point where it is the guided one.
[[nodiscard]] inline std::vector<Vector3> plate_corners(const MovingLinkage& linkage, int body) {
  std::vector<Vector3> corners;
  for (const std::size_t hinge : linkage.hinges_of(body)) corners.push_back(linkage.hinges[hinge].point);
  if (linkage.traced && body == linkage.guided) corners.push_back(*linkage.traced);
  return corners;
}

/// The layers of what a hinge joins, the lower one first.
[[nodiscard]] inline std::pair<int, int> pin_layers(const Hinge& hinge, const std::vector<int>& layer) {
  return std::minmax(
      {layer[static_cast<std::size_t>(hinge.bodies[0])], layer[static_cast<std::size_t>(hinge.bodies[1])]});
}

}  // namespace linkwright
