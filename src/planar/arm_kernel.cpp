#include "planar/arm_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(arm_kernel)(ArmBlock& block) { LINKWRIGHT_ISA::arm_kernel<LINKWRIGHT_LANES>(block); }

}  // namespace linkwright
