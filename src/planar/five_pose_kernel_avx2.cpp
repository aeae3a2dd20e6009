#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "planar/five_pose_lanes.hpp"

namespace linkwright {

void five_pose_kernel_avx2(FivePoseBlock& block) { isa_avx2::five_pose_kernel<4>(block); }

}  // namespace linkwright
#endif
