#include "spherical/five_orientation_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(five_orientation_kernel)(FiveOrientationBlock& block) {
  LINKWRIGHT_ISA::five_orientation_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
