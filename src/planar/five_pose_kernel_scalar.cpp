#define LINKWRIGHT_ISA isa_scalar
#include "planar/five_pose_lanes.hpp"

namespace linkwright {

void five_pose_kernel_scalar(FivePoseBlock& block) { isa_scalar::five_pose_kernel<1>(block); }

}  // namespace linkwright
