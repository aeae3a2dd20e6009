#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "planar/five_pose_lanes.hpp"

namespace linkwright {

void five_pose_kernel_avx512(FivePoseBlock& block) { isa_avx512::five_pose_kernel<8>(block); }

}  // namespace linkwright
#endif
