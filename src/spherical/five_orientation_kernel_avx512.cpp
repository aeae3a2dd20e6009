#if defined(__x86_64__)
#define LINKWRIGHT_ISA isa_avx512
#include "spherical/five_orientation_lanes.hpp"

namespace linkwright {

void five_orientation_kernel_avx512(FiveOrientationBlock& block) { isa_avx512::five_orientation_kernel<8>(block); }

}  // namespace linkwright
#endif
