#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

/// What acts on a linkage that is to be made, and where it lies.
struct LinkageLoads {
  Loads loads;
  FourBar bars;                       ///< in position 1
  std::vector<PrescribedPose> poses;  ///< of the task, one at least
};

/// Among the bodies of the four-bar's MovingLinkage.
[[nodiscard]] inline int moving_body(LoadedBody on) {
  constexpr std::array<int, loaded_body_names.size()> bodies = {0, 1, 2, 2, 3};
  return bodies[static_cast<std::size_t>(on)];
}

}  // namespace linkwright
