#define LINKWRIGHT_ISA isa_baseline
#include "planar/five_pose_lanes.hpp"

namespace linkwright {

void five_pose_kernel_baseline(FivePoseBlock& block) { isa_baseline::five_pose_kernel<2>(block); }

}  // namespace linkwright
