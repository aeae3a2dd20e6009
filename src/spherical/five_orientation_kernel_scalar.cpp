#define LINKWRIGHT_ISA isa_scalar
#include "spherical/five_orientation_lanes.hpp"

namespace linkwright {

void five_orientation_kernel_scalar(FiveOrientationBlock& block) { isa_scalar::five_orientation_kernel<1>(block); }

}  // namespace linkwright
