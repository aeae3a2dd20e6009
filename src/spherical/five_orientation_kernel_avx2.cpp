#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx2
#include "spherical/five_orientation_lanes.hpp"

namespace linkwright {

void five_orientation_kernel_avx2(FiveOrientationBlock& block) { isa_avx2::five_orientation_kernel<4>(block); }

}  // namespace linkwright
#endif
