#define LINKWRIGHT_ISA isa_baseline
#include "spherical/five_orientation_lanes.hpp"

namespace linkwright {

void five_orientation_kernel_baseline(FiveOrientationBlock& block) { isa_baseline::five_orientation_kernel<2>(block); }

}  // namespace linkwright
