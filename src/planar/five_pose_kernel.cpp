#include "planar/five_pose_lanes.hpp"

namespace linkwright {

void LINKWRIGHT_KERNEL(five_pose_kernel)(FivePoseBlock& block) {
  LINKWRIGHT_ISA::five_pose_kernel<LINKWRIGHT_LANES>(block);
}

}  // namespace linkwright
